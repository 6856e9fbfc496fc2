#pragma once

#include <wheelrail/contactfiles/control_digits.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  // A case of an input file of CONTACT as it counts: what it states, and what it keeps of the case before.
  // Lengths in mm, forces in N, stresses in N/mm2, velocities in mm/s, angles in rad; signs of CONTACT.
  // `line` is that of the file where values were read, 0 where they never were.

  /// Units of CONTACT's files in those of the program.
  constexpr double millimetre = 1e-3, megapascal = 1e6;

  /// Elements of a grid, and points below the surface, at most.
  constexpr int most_contact_elements = 1000000;

  /// Numbers of the solvers: outer and inner loops, relative tolerance.
  struct ContactIteration
  {
    int          maxgs = 999, maxin = 20, maxnr = 25, maxout = 1;
    double       eps          = 1e-5;
    double       largest      = 20000; ///< NPOT_MAX, elements
    int          initial_slip = 0;     ///< INISLP: below 0 falling friction is solved from sliding on
    unsigned int line         = 0;
  };

  /// What presses and moves the bodies of module 3.
  struct ContactKinematics
  {
    double       normal = 0;             ///< PEN (N = 0) or FN
    double       x = 0, y = 0;           ///< CKSI or, over FSTAT * FN, FX (F >= 1); CETA or FY (F = 2)
    double       spin   = 0;             ///< CPHI [rad/mm]
    double       spin_x = 0, spin_y = 0; ///< SPINXO, SPINYO: where the spin's slip is zero
    unsigned int line = 0;
  };

  /// Constants of the friction law at an inclination (V = 1, rad), a place along the track (V = 2) or in a
  /// row of the grid (V = 3): FSTAT, FKIN (L = 0); FKIN, F1, SH1, F2, SH2 (L = 2 to 4); FREF, TREF, DFHEAT,
  /// DTHEAT (L = 6).
  struct ContactFrictionLine
  {
    double              place = 0;
    std::vector<double> constants;
    unsigned int        line = 0;
  };

  struct ContactFriction
  {
    std::vector<ContactFrictionLine> lines;
    double                           memory_length = 0, memory_speed = 0; ///< MEMDST, MEM_S0
    unsigned int                     line = 0;
  };

  struct ContactRolling
  {
    double       direction = 0;      ///< CHI
    double       step      = 1;      ///< DQ
    double       velocity  = 1000;   ///< VELOC
    double       middle    = 1. / 6; ///< FACPHI: where in the step the spin counts
    unsigned int line      = 0;
  };

  struct ContactInfluence
  {
    int                                    method = 0, variant = 4; ///< IF_METH, VARIANT of C = 4
    std::vector<std::pair<double, double>> surface;                 ///< its y and inclination, module 3
    std::string                            file;                    ///< of C = 9
    unsigned int                           line = 0;
  };

  struct ContactMaterial
  {
    std::array<double, 2> poisson{{0.28, 0.28}}, shear{{1, 1}}; ///< of bodies 1 and 2
    double                normal_flexibility = 0;               ///< FLXZ [mm3/N]
    int                   constants_of       = 0;               ///< the digit M for which they stand
    std::vector<double>   constants;        ///< as the digit M asks for, in the order of the file
    std::vector<double>   damping;          ///< CDAMPN CDAMPT DFNMAX DFTMAX
    std::vector<double>   heat;             ///< BKTEMP HEATCP LAMBDA DENS of bodies 1 and 2
    double                plastic_heat = 1; ///< BETAPL
    unsigned int          line = 0, heat_line = 0;

    /// Whether pressure shifts the surfaces against each other by less than 1e-4 of what it presses them.
    bool
    alike() const;
  };

  /// Elements and patches of module 1.
  struct ContactElements
  {
    double       dx = 0, ds = 0;
    double       relative_step = 1;                ///< DQREL: rolled distance of a step over dx
    double       a_sep = 0, d_sep = 0, d_comb = 0; ///< when patches are apart: angle, distances
    double       d_turn     = 0;                   ///< 2 d_sep - d_comb unless stated
    double       missed_gap = -1;                  ///< G_MISS
    unsigned int line       = 0;
  };

  struct ContactProfile
  {
    std::string                            file;   ///< with its folder, as it can be opened
    std::vector<std::pair<double, double>> points; ///< of a caller, in place of the file: y, z [mm]
    int                                    mirror_y = 0, mirror_z = 0, options = 0;
    double                                 scale = 1, smoothing = 0;
    int                                    smoothing_method = 0; ///< ISMOOTH
    double       zigzag = 2.6179938779914944, kink_high = 0.5235987755982988, kink_low = 0.10471975511965977;
    double       kink_width     = 2;
    int          error_handling = 0;
    double       largest_gap    = 0.5; ///< MAXOMIT
    unsigned int line           = 0;
  };

  struct ContactTrack
  {
    double                gauge_height = 0; ///< GAUGHT; <= 0: the rail is placed by rail_y, rail_z
    double                gauge = 0, gauge_sequence = 0;
    double                rail_y = 0, rail_z = 0;
    double                cant = 0, curvature = 0;
    double                roller_radius = 0; ///< NOMRADR, configurations 4 and 5
    std::array<double, 6> deviation{};       ///< DYRAIL DZRAIL DROLLR and their velocities
    std::vector<double>   springs;           ///< KYRAIL FYRAIL KZRAIL FZRAIL {DYSTEP0}
    ContactProfile        profile;
    unsigned int          line = 0, deviation_line = 0;
  };

  struct ContactWheelset
  {
    double                 flange_distance = 0, flange_place = 0, radius = 0;
    std::vector<double>    tape_place; ///< YTAPE, if it is stated
    std::array<double, 6>  position{}; ///< S or X, Y, Z or FZ (N = 1), roll, yaw, pitch
    std::array<double, 6>  velocity{}; ///< VS or RPITCH, VY, VZ, roll, yaw, pitch rate or FX_WS (F = 1)
    std::array<double, 12> flexible{}; ///< displacements and velocities
    ContactProfile         profile;
    unsigned int           line = 0, position_line = 0, velocity_line = 0;
  };

  /// The potential contact of module 3: IPOTCN, MX, MY and the further numbers of its line.
  struct ContactGrid
  {
    int                 kind = 0, mx = 0, my = 0;
    std::vector<double> values;
    unsigned int        line = 0;

    /// Why it cannot have so many elements; empty: it can.
    std::string
    fault_of_size() const;

    /// Rows within the strip of IPOTCN = -4 and -5, whose half width they divide; the others lie beside it.
    int
    rows_of_strip() const;

    /// Corner x, y of the grid and element lengths dx, dy [mm], of IPOTCN > 0.
    std::array<double, 4>
    corner() const;
  };

  /// Undeformed distance of module 3 (IPOTCN > 0).
  struct ContactDistance
  {
    int                 base = 1, planform = 1;
    std::vector<double> values; ///< of IBASE: coefficients, XM RM Y1 DY1 and heights, or one of each element
    std::vector<double> plan;   ///< of IPLAN
    unsigned int        line = 0;
  };

  struct ContactExtraSlip
  {
    std::vector<double> x, y; ///< of each element [-], or mm in shifts
    unsigned int        line = 0;
  };

  /// Points below the surface: ISUBS, integers (counts, first, step, last, indices) and coordinates.
  struct ContactPoints
  {
    int                 kind = 0;
    std::vector<int>    counts;
    std::vector<double> x, y, z;
    unsigned int        line = 0;
  };

  struct ContactCase
  {
    std::string                 file;
    int                         module = 3, element = 0, problem = 0; ///< REID, CPID
    int                         number = 0; ///< counted from 1 in each result element
    unsigned int                line   = 0; ///< of its first control word
    std::array<unsigned int, 3> word_lines{};

    std::vector<std::string> notes; ///< on values that are not read, with file and line

    ControlDigits written; ///< as they stand in the file
    ControlDigits digits;  ///< what counts: digits that keep are those of the case before

    ContactIteration iteration;
    ContactFriction  friction;
    ContactInfluence influence;
    ContactMaterial  material;
    // module 3
    ContactKinematics kinematics;
    ContactRolling    rolling;
    ContactGrid       grid;
    ContactDistance   distance;
    ContactExtraSlip  extra_slip;
    // module 1
    ContactElements elements;
    ContactTrack    track;
    ContactWheelset wheelset;

    int                        points_file = 0, points_output = 0; ///< A_s, O_s
    std::vector<ContactPoints> points;
    unsigned int               points_line = 0;
  };
} // namespace wheelrail
