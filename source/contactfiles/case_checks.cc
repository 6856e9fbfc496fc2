#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/sections/slices_file.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    [[noreturn]] void
    fail(const ContactCase &one, const unsigned int line, const std::string &text)
    {
      throw InputError(place(one.file, line) + text);
    }

    /// Digits that exclude each other, of all modules and of each.
    void
    check_digits(const ContactCase &one, const ContactCase *before)
    {
      const ControlDigits &d     = one.digits;
      const unsigned int   first = one.word_lines[0], second = one.word_lines[1], third = one.word_lines[2];
      const bool           basic = one.module == 3;
      if (d.material == 1 && d.motion != 3)
        fail(one, second, "M = 1 (viscoelastic) needs T = 3 (steady rolling)");
      if (d.material == 1 && basic && one.rolling.direction != 0)
        fail(one, one.rolling.line, "M = 1 (viscoelastic) needs CHI = 0");
      if (d.law == 6 && (d.heat == 0 || d.material == 2 || d.material == 3 || d.material == 5))
        fail(one, second, "L = 6 (friction by temperature) needs H = 1 or 3 and none of M = 2, 3, 5");
      if (d.heat == 3 && d.motion != 0 && d.motion != 3)
        fail(one, third, "H = 3 (heat) needs T = 0 (no friction) or 3 (steady rolling)");
      if (one.written.law == 1 && before && d.variation != before->digits.variation)
        fail(one, second, "the digit V may not change where L = 1 keeps the friction of the case before");
      if (!basic && d.forces == 1 && d.normal != 1)
        fail(one, first, "F = 1 (FX_WS given) needs N = 1 (force given)");
      if (basic && (d.bound == 5 || d.bound == 6) && d.normal != 0)
        fail(one, first, "B = 5 and 6 need N = 0 (approach given)");
      if (basic && one.written.grid != 0 && one.written.geometry == 0)
        fail(one, second, "D = 1 and 2 (potential contact) need Z = 2 (undeformed distance)");
      if (d.material != 0 && d.material != one.material.constants_of)
        fail(one,
             second,
             "M = " + std::to_string(d.material) +
               " has no constants: C = " + std::to_string(one.written.influence) + " keeps those of M = " +
               std::to_string(one.material.constants_of) + "; set C = 2 and state them");
    }

    /// What a first case has to state.
    void
    check_stated(const ContactCase &one)
    {
      const unsigned int second = one.word_lines[1];
      if (one.track.line == 0 || one.track.profile.line == 0)
        fail(
          one, second, "no case has stated the track and the profile of the rail; set Z = 3 and state them");
      if (one.wheelset.line == 0)
        fail(one,
             second,
             "no case has stated the wheelset and the profile of the wheel; set E = 3 and state them");
    }

    /// A rail on springs (F = 3): KYRAIL FYRAIL KZRAIL FZRAIL; KZRAIL counts where the height is given.
    void
    check_springs(const ContactCase &one)
    {
      const std::vector<double> &springs = one.track.springs;
      if (springs.size() < 4)
        fail(one,
             one.word_lines[1],
             "no case has stated the springs of the rail, which F = 3 needs; set Z = 2 or 3 and state them");
      if (!(springs[0] > 0) || (one.digits.normal == 0 && !(springs[2] > 0)))
        fail(one, one.track.deviation_line, "KYRAIL or KZRAIL, the stiffness of a spring, is not positive");
    }

    /// Numbers of module 1 that calls can set to anything.
    void
    check_finite(const ContactCase &one)
    {
      const ContactTrack    &track    = one.track;
      const ContactWheelset &wheelset = one.wheelset;
      const ContactElements &elements = one.elements;
      std::vector<double>    all{track.gauge_height,
                              track.gauge,
                              track.rail_y,
                              track.rail_z,
                              track.cant,
                              track.roller_radius,
                              wheelset.flange_distance,
                              wheelset.flange_place,
                              wheelset.radius,
                              elements.dx,
                              elements.ds,
                              elements.a_sep,
                              elements.d_sep,
                              elements.d_comb,
                              elements.d_turn};
      all.insert(all.end(), track.deviation.begin(), track.deviation.end());
      all.insert(all.end(), wheelset.position.begin(), wheelset.position.end());
      all.insert(all.end(), wheelset.velocity.begin(), wheelset.velocity.end());
      all.insert(all.end(), wheelset.flexible.begin(), wheelset.flexible.end());
      constexpr double most = 1e12;
      if (!std::all_of(all.begin(), all.end(), [](const double v) { return std::abs(v) < most; }))
        fail(
          one, one.line, "a number of the track, the wheelset or the elements is not finite, or beyond 1e12");
      if (!(elements.dx > 0 && elements.dx <= 100 && elements.ds > 0 && elements.ds <= 100))
        fail(one, elements.line, "DX and DS, the size of the elements, are not from 0 to 100 mm");
      if (!(wheelset.radius > 0) || (one.digits.side >= 4 && !(track.roller_radius > 0)))
        fail(one, wheelset.line, "NOMRADW, or NOMRADR of a roller, is not positive");
    }

    /// A grid has to be that of the case before, shifted by whole elements.
    bool
    continues(const ContactGrid &grid, const ContactGrid &other)
    {
      const std::array<double, 4> a = grid.corner(), b = other.corner();
      for (int k = 0; k < 2; ++k)
        {
          const double offset = (a[k] - b[k]) / a[k + 2];
          if (std::abs(a[k + 2] - b[k + 2]) > 1e-6 * a[k + 2] || std::abs(offset - std::round(offset)) > 1e-6)
            return false;
        }
      return true;
    }

    void
    check_basic(const ContactCase &one, const ContactCase *before)
    {
      const ControlDigits &d    = one.digits;
      const ContactGrid   &grid = one.grid;
      if ((d.bound == 2 || d.bound == 3) && grid.kind > 0)
        fail(
          one, one.word_lines[0], "B = 2 and 3 (given pressure) need a Hertzian contact, IPOTCN = -6 to -1");
      if ((d.bound == 4) != (grid.kind == -6))
        fail(one, one.word_lines[0], "B = 4 and IPOTCN = -6 (two half ellipses) need each other");
      if ((grid.kind == -4 || grid.kind == -5) && d.normal != 1)
        fail(one, grid.line, "IPOTCN = -4 and -5 need N = 1 (force given)");
      if (grid.kind > 0 && one.distance.line == 0)
        fail(one, one.word_lines[1], "no case has stated the undeformed distance; set Z = 2 and state it");
      if (d.motion >= 2 && one.rolling.line == 0)
        fail(
          one,
          one.word_lines[1],
          "no case has stated CHI, DQ and VELOC, which rolling (T = 2, 3) needs; set C = 2 and state them");
      const std::size_t n = std::size_t(grid.mx) * std::size_t(grid.my);
      if (grid.kind > 0 && one.distance.base == 9 && one.distance.values.size() != n)
        fail(one,
             grid.line,
             "the grid has not as many elements as the undeformed distance kept of the case before");
      if (d.extra == 9 && one.extra_slip.x.size() != n)
        fail(one,
             grid.line,
             "the grid has not as many elements as the extra rigid slip kept of the case before");
      if (d.variation == 3 && one.friction.lines.size() != std::size_t(grid.my))
        fail(one, grid.line, "the grid has not as many rows as the friction kept of the case before");
      const bool goes_on = d.past < 2 || d.past == 3 || d.start > 0;
      if (before && goes_on && grid.kind > 0 && before->grid.kind > 0 && !continues(grid, before->grid))
        fail(
          one,
          grid.line,
          "the grid is not that of the case before, shifted by whole elements; P = 0, 1, 3 and I = 1, 2, 3 "
          "need it");
    }
  } // namespace


  void
  check_case(const ContactCase &one, const ContactCase *before)
  {
    check_digits(one, before);
    if (one.module == 3)
      return check_basic(one, before);
    check_stated(one);
    check_finite(one);
    if (one.digits.forces == 3)
      check_springs(one);
    if (before && one.digits.past != 2 && (one.digits.motion == 1 || one.digits.motion == 2) &&
        (one.elements.dx != before->elements.dx || one.elements.ds != before->elements.ds))
      fail(one, one.elements.line, "DX and DS may not change where shifts and transient rolling go on");
  }


  namespace
  {
    /// Influences corrected for the turn of the normal.
    template <typename Add>
    void
    refuse_angle_correction(const ContactCase &one, const Add &add)
    {
      const ControlDigits &d = one.digits;
      if (one.module == 1 && d.grid != 4)
        add(one.word_lines[1],
            "C = 4 (angle correction) on a plane, D = " + std::to_string(d.grid),
            "taken is D = 4");
      if (d.motion == 1 || d.motion == 2)
        add(one.word_lines[1],
            "C = 4 (angle correction) with T = " + std::to_string(d.motion),
            "taken are T = 0 and 3");
      if (one.influence.method != 1 || one.influence.variant != 3)
        add(one.influence.line,
            "IF_METH = " + std::to_string(one.influence.method) +
              " with VARIANT = " + std::to_string(one.influence.variant),
            "taken is IF_METH = 1 with VARIANT = 3 (displacements turned)");
    }

    /// Values of module 3.
    template <typename Add>
    void
    refuse_basic(const ContactCase &one, const Add &add)
    {
      const ControlDigits &d     = one.digits;
      const int            kind  = one.grid.kind;
      const bool           strip = kind == -4 || kind == -5;
      if (kind == -6)
        add(one.grid.line, "IPOTCN = -6", "taken are -5 to -1 (ellipses, strips) and 1 to 4 (grids)");
      if (strip && d.bound < 2 && one.grid.rows_of_strip() < one.grid.my)
        add(one.grid.line,
            "IPOTCN = " + std::to_string(kind) +
              " (a strip) with rows beside it, SCALE > 1, and B = " + std::to_string(d.bound),
            "taken are SCALE <= 1, and B = 2 and 3");
      if ((kind > 0 || strip) && (d.material == 2 || d.material == 3))
        add(one.word_lines[1],
            "M = " + std::to_string(d.material) + " (FASTSIM) on a contact that is no ellipse",
            "taken are IPOTCN = -3 to -1");
      if ((d.material == 2 || d.material == 3) && d.motion != 3 && d.motion != 0)
        add(one.word_lines[1], "M = 2, 3 (FASTSIM) without T = 3 (steady rolling)", "taken is T = 3");
      if (kind > 0 && one.distance.planform == 4)
        add(one.distance.line, "IPLAN = 4 (weighted patches)", "taken are 1 (all elements), 2 and 3");
      if (d.motion >= 2 && std::abs(std::sin(one.rolling.direction)) > 1e-3)
        add(one.rolling.line, "CHI other than 0 and 180d (rolling across x)", "taken are 0 and 180d");
      const ContactKinematics &k = one.kinematics;
      if (d.motion != 0 && d.forces >= 1 && std::hypot(k.x, d.forces == 2 ? k.y : 0) >= 1)
        add(k.line,
            "a force FX, FY of FSTAT times FN or more (sliding as a whole)",
            "taken are smaller ones, and creepages of any size");
    }

    /// Values of module 1.
    template <typename Add>
    void
    refuse_profile(const ContactProfile &profile, const bool wheel, const Add &add)
    {
      const std::string name = std::filesystem::path(profile.file).filename().string();
      if (is_slices_file(profile.file) && !wheel && profile.mirror_z == 0)
        add(profile.line,
            "MIRRORZ = 0 (up or down found from the points) of the slices " + name,
            "taken are -1 (z points down) and 1");
      if (profile.smoothing != 0 && is_slices_file(profile.file))
        add(profile.line, "SMOOTH other than 0 with slices", "taken is SMOOTH = 0");
      if (profile.smoothing != 0 && profile.smoothing_method != 0)
        add(profile.line,
            "ISMOOTH = " + std::to_string(profile.smoothing_method) + " (SMOOTH as the length of a filter)",
            "taken is ISMOOTH = 0 (a smoothing spline)");
      if (profile.smoothing < 0)
        add(profile.line, "SMOOTH below 0", "taken are 0 (no smoothing) and positive weights");
    }

    template <typename Add>
    void
    refuse_wheel_rail(const ContactCase &one, const Add &add)
    {
      refuse_profile(one.track.profile, false, add);
      refuse_profile(one.wheelset.profile, true, add);
      const ControlDigits &d      = one.digits;
      const bool           slices = is_slices_file(one.track.profile.file),
                 out_of_round     = is_slices_file(one.wheelset.profile.file);
      if ((slices || out_of_round || d.side >= 4) && (d.motion == 1 || d.motion == 2))
        add(one.word_lines[0],
            "T = " + std::to_string(d.motion) +
              (slices         ? " on rails by slices"
               : out_of_round ? " with wheels by slices"
                              : " on rollers"),
            "taken are T = 0 and 3");
      if ((slices || out_of_round || d.side >= 4) && d.grid == 4)
        add(one.word_lines[1], "D = 4 (conformal) on rollers or slices", "taken are D = 2 and 5");
      if (d.forces == 3 && d.motion != 3)
        add(one.word_lines[0],
            "F = 3 (rail on springs) with T = " + std::to_string(d.motion),
            "taken is T = 3 (steady rolling)");
      if (d.forces == 3 && (slices || d.side >= 4))
        add(one.word_lines[0],
            "F = 3 (rail on springs) on rollers or slices",
            "taken are rails of one section");
      if (slices && d.side >= 4)
        add(one.track.profile.line, "a roller by slices", "taken are profiles of one section");
      if (slices && one.track.gauge_height > 0)
        add(one.track.line, "GAUGHT > 0 (gauge) with slices", "taken is their place, RAILY0 and RAILZ0");
      const std::vector<double> &c = one.material.constants;
      if (d.material == 4 && d.motion < 3 && c[2] > 0 && c[2] < 1e10)
        add(one.material.line,
            "TAU_C0 > 0 (an interfacial layer that yields) with T = " + std::to_string(d.motion),
            "taken are T = 3 and TAU_C0 = 0");
      if (one.track.curvature != 0)
        add(one.track.line, "CURV other than 0 (a curved track)", "taken are straight tracks");
      if (!one.wheelset.tape_place.empty())
        add(one.wheelset.line, "YTAPE (NOMRADW at another place than z = 0)", "taken are files without it");
      if (one.elements.missed_gap >= 0)
        add(one.elements.line, "G_MISS >= 0 (near misses)", "taken is -1");
    }
  } // namespace


  std::vector<std::string>
  refusals(const ContactCase &one)
  {
    std::vector<std::string> found;
    const auto add = [&](const unsigned int line, const std::string &what, const std::string &instead) {
      found.push_back(place(one.file, line) + what + " is not computed; " + instead);
    };
    for (const ControlDigit &digit : control_digits())
      {
        if (digit.module != 0 && digit.module != one.module)
          continue;
        const int               value = one.digits.*digit.place;
        const DigitValue *const entry = digit_value(digit, value);
        if (!entry || entry->use != DigitValue::not_taken)
          continue;
        const unsigned int line = one.word_lines[digit.word == 4 ? 1 : digit.word - 1];
        add(line,
            std::string(1, digit.letter) + " = " + std::to_string(value) + " (" + digit.name + ": " +
              entry->meaning + ")",
            "taken are " + accepted_digits(digit, {DigitValue::taken, DigitValue::kept}));
      }
    if (one.digits.influence == 4)
      refuse_angle_correction(one, add);
    if (one.digits.heat != 0 && (one.digits.motion == 1 || one.digits.motion == 2))
      add(one.word_lines[2],
          "H = " + std::to_string(one.digits.heat) + " (heat) with T = " + std::to_string(one.digits.motion),
          "taken is T = 3 (steady rolling)");
    if (one.module == 3)
      refuse_basic(one, add);
    else
      refuse_wheel_rail(one, add);
    return found;
  }
} // namespace wheelrail
