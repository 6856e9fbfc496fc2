#include <wheelrail/base/print.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/passage_jumps.h>
#include <wheelrail/run/passage_table.h>
#include <wheelrail/state/rail_state.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    /// Rounds that are computed after each jump before the next one: the first still settles, the second is
    /// held against the jump, the third gives the rate of growth.
    constexpr unsigned int after_jump = 3;

    /// Rounds at the begin of a family, whose growth falls fast.
    constexpr unsigned int before_jump = 4;
  } // namespace


  PassageJumps::PassageJumps(const Scene       &scene,
                             const unsigned int of_round,
                             const unsigned int most,
                             MPI_Comm           communicator)
    : scene_(scene)
    , of_round_(of_round)
    , most_(most)
    , longest_(scene.passage_jump)
    , communicator_(communicator)
  {
  }


  /// After a jump that was taken back the next one is half as long, after one that was kept up to twice.
  void
  PassageJumps::learn_from(const PassageJump &jump)
  {
    const unsigned int n = (jump.to - jump.from) / of_round_;
    longest_             = jump.kept ? std::min(scene_.passage_jump, 2 * n) : n / 2;
  }


  void
  PassageJumps::read_old()
  {
    jumps_ = read_jumps(scene_.folder);
    for (const PassageJump &jump : jumps_)
      if (jump.judged)
        learn_from(jump);
    MPI_Barrier(communicator_);
  }


  unsigned int
  PassageJumps::stand(const std::vector<unsigned int> &computed) const
  {
    const unsigned int last = computed.empty() ? 0 : computed.back();
    for (const PassageJump &jump : jumps_)
      if (jump.from == last && !(jump.judged && !jump.kept))
        return jump.to;
    return last;
  }


  void
  PassageJumps::judge(std::vector<unsigned int> &computed)
  {
    if (jumps_.empty() || jumps_.back().judged || computed.back() != jumps_.back().to + 2 * of_round_)
      return;
    PassageJump &jump   = jumps_.back();
    const double strain = left_in_rail(scene_.folder, jump.to + 2 * of_round_).strain;
    judge_jump(jump,
               (jump.to - jump.from) / of_round_,
               strain - left_in_rail(scene_.folder, jump.to + of_round_).strain,
               strain,
               scene_.jump_error);
    MPI_Barrier(communicator_);
    on_root(communicator_, [&]() {
      char words[160];
      std::snprintf(
        words,
        sizeof(words),
        "Jump from passage %u to %u: the growth computed after it differs by %.2g %% of the strain",
        jump.from,
        jump.to,
        100 * jump.error);
      print(STDOUT_FILENO,
            std::string(words) +
              (jump.kept ? "\n"
                         : ", more than Run/Jump error; it is taken back, the next one is half as long\n"));
      write_jumps(jumps_, scene_.folder);
      if (!jump.kept)
        for (unsigned int k = jump.to; k <= jump.to + 2 * of_round_; ++k)
          std::filesystem::remove_all(passage_folder(scene_.folder, k));
    });
    learn_from(jump);
    if (!jump.kept)
      computed.resize(computed.size() - 2 * of_round_);
  }


  /// Extrapolates the rail over some rounds from the last one; whether that is possible.
  bool
  PassageJumps::jump_over(const std::vector<unsigned int> &computed,
                          const JumpBasis                 &basis,
                          const unsigned int               rounds)
  {
    const unsigned int k = computed.back();
    PassageJump        jump;
    jump.from   = k;
    jump.to     = k + rounds * of_round_;
    jump.growth = basis.growth;
    jump.rate   = basis.rate;
    jumps_.push_back(jump);
    int done = 0;
    on_root(communicator_, [&]() {
      done = extrapolate_rail(passage_folder(scene_.folder, k - of_round_),
                              passage_folder(scene_.folder, k),
                              jump_factor(jump.rate, rounds),
                              passage_folder(scene_.folder, jump.to));
      if (!done)
        return;
      write_jumps(jumps_, scene_.folder);
      print(STDOUT_FILENO,
            "Passages " + std::to_string(k + 1) + " to " + std::to_string(jump.to) + " are extrapolated\n");
    });
    MPI_Bcast(&done, 1, MPI_INT, 0, communicator_);
    if (done == 0) // the cells that have flowed have changed
      jumps_.pop_back();
    return done != 0;
  }


  /// Growths up to a passage that ends a round, `last` being the last jump that was kept.
  JumpBasis
  PassageJumps::basis_of(const unsigned int passage, const PassageJump *last) const
  {
    const auto before = [&](const unsigned int rounds) {
      return left_in_rail(scene_.folder, passage - rounds * of_round_).strain;
    };
    const double now = before(0), one = before(1), two = before(2);
    // growth does not go on growing
    const auto rate = [](const double of, const double over) {
      return over > 0 && of > 0 ? std::min(1., of / over) : 0;
    };
    JumpBasis basis;
    basis.strain = now;
    basis.growth = now - one;
    basis.rate   = rate(now - one, one - two);
    basis.before = last == nullptr ? rate(one - two, two - before(3)) : std::min(1., last->computed_rate);
    return basis;
  }


  void
  PassageJumps::try_jump(const std::vector<unsigned int> &computed)
  {
    const unsigned int k = computed.back();
    if (longest_ < 2 || k % of_round_ != 0 || stand(computed) != k ||
        (!jumps_.empty() && !jumps_.back().judged))
      return;
    const PassageJump *last = nullptr;
    for (const PassageJump &jump : jumps_)
      if (jump.kept)
        last = &jump;
    if (k < of_round_ * (last == nullptr ? before_jump : last->to / of_round_ + after_jump))
      return;
    const JumpBasis basis = basis_of(k, last);
    // enough rounds must follow to judge it
    const unsigned int rounds = (most_ - k) / of_round_;
    const unsigned int left   = rounds > after_jump ? rounds - after_jump : 0;
    const unsigned int n      = jump_length(basis, std::min(longest_, left), scene_.jump_error);
    if (basis.growth > 0 && n >= 2)
      jump_over(computed, basis, n);
  }
} // namespace wheelrail
