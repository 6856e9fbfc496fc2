#pragma once

#include <wheelrail/bodies/section_waves.h>
#include <wheelrail/mesh/section.h>
#include <wheelrail/receptance/hammer.h>
#include <wheelrail/scene/rail_support.h>
#include <wheelrail/track/track_support.h>

#include <array>
#include <complex>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// How a force or an observation is spread along the rail, around its place; the integral of `even` ones
  /// is 1.
  struct Spread
  {
    enum Kind
    {
      bump, ///< (1 + cos(pi s/half))/(2 half)
      even, ///< 1/(2 half)
      tilt  ///< sqrt(3) s/half/(2 half): turns, with the same mean of squares over the stretch
    };
    Kind   kind = even;
    double half = 0; ///< half of its length [m]

    double
    at(double s) const;
  };

  /// The mean of waves exp(-i k |x|) over two spreads, as a sum of weights at distances.
  struct SpreadPair
  {
    std::vector<double> distance, weight; ///< [m], [1]

    /// Spread a lies `ahead` [m] of b. `odd`: waves have the sign of the distance, too.
    SpreadPair(const Spread &a, const Spread &b, double ahead, bool odd);

    std::complex<double>
    mean(std::complex<double> k) const;
  };

  /// What the foot can do to pads, by forces of the section: normal to it, even and tilting over its width
  /// and bending, across, along, and along tilting over its width.
  enum FootForce : unsigned int
  {
    normal_even,
    normal_tilt,
    normal_bend,
    across_even,
    along_even,
    along_tilt,
    n_foot_forces
  };

  /// The receptance of an endless rail on the track of a scene by the waves of its section (SectionWaves): a
  /// second method that shares neither elements nor time steps with the run. Pads lie below the foot as those
  /// of TrackSupport do; at sleepers the rail is free between some 30 of them around the hammer.
  class TrackWaves
  {
  public:
    /// `section`: in the track plane; `faces`: of the rail, the first one is struck. A loss factor of the
    /// steel keeps waves of a free rail apart.
    TrackWaves(const Section                 &section,
               const Elasticity              &elasticity,
               RailSupport                    support,
               const TrackData               &track,
               const std::vector<HammerFace> &faces);

    /// Takes another track below the same rail, of the same kind of support.
    void
    stand_on(const TrackData &track)
    {
      track_ = track;
    }

    /// Displacements of the faces over the force on the first one [m/N], at a frequency [Hz], faded by
    /// exp(-fading t) [1/s].
    std::vector<std::complex<double>>
    receptances(double frequency, double fading) const;

    /// The frequency at which a wave of the unsupported rail, moving along the struck direction, is twice as
    /// long as a bay: pinned-pinned [Hz].
    double
    pinned_pinned() const;

    const SectionWaves &
    waves() const
    {
      return *waves_;
    }

    /// Loss factor of the steel.
    static constexpr double loss = 2e-4;

  private:
    /// A force of the section, spread along the rail.
    struct Piece
    {
      unsigned int force = 0;
      Spread       spread;
    };

    void
    add_faces(const SectionMesh &mesh, const std::vector<HammerFace> &faces);
    void
    add_foot(const SectionMesh &mesh, const std::vector<std::array<unsigned int, 3>> &foot);
    std::vector<std::complex<double>>
    pad_stiffness(std::complex<double> w) const;
    std::vector<std::complex<double>>
    of_free_rail(const std::vector<SectionWaves::Wave> &waves) const;
    void
    add_sleepers(std::complex<double>                   w,
                 const std::vector<SectionWaves::Wave> &waves,
                 std::vector<std::complex<double>>     &moved) const;

    RailSupport                   support_;
    TrackData                     track_;
    WaveMatrices                  matrices_;
    std::vector<SectionForce>     forces_; ///< of the faces, then of the foot
    std::vector<unsigned int>     face_force_;
    std::vector<double>           face_place_; ///< [m]
    Spread                        face_spread_;
    unsigned int                  first_foot_ = 0;
    std::array<Vector3, 2>        axes_{}; ///< of the foot: across, normal
    std::unique_ptr<SectionWaves> waves_;
  };
} // namespace wheelrail
