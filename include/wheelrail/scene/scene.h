#pragma once

#include <wheelrail/damage/laws.h>
#include <wheelrail/damage/wear_plan.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/material/cyclic_hardening.h>
#include <wheelrail/material/friction.h>
#include <wheelrail/mesh/wheel_section_outline.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/profiles/slices_file.h>
#include <wheelrail/scene/irregularity_data.h>
#include <wheelrail/scene/material_test.h>
#include <wheelrail/scene/rail_support.h>
#include <wheelrail/scene/study.h>
#include <wheelrail/solid/element_form.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// How steel answers beyond yield.
  enum class SteelLaw
  {
    elastic,  ///< it does not yield
    bilinear, ///< linear hardening; elastic while there is no yield stress
    chaboche  ///< cyclic hardening
  };

  /// Steel [SI].
  struct MaterialData
  {
    SteelLaw    law                 = SteelLaw::bilinear;
    double      youngs_modulus      = 210e9;
    double      poissons_ratio      = 0.3;
    double      density             = 7900;
    double      yield_stress        = std::numeric_limits<double>::infinity(); ///< infinite: elastic
    double      tangent_modulus     = 21e9;
    double      kinematic_hardening = 0;     ///< fraction, 0 isotropic, 1 kinematic
    std::string steel               = "any"; ///< by which elastic results are judged, see scene/steels.h
    /// Of the law of Chaboche; its yield stress is the one above.
    CyclicHardening cyclic;

    /// Whether the steel may yield.
    bool
    yields() const
    {
      return law != SteelLaw::elastic && std::isfinite(yield_stress);
    }
  };

  /// Narrowest curve of a track [m]; those of trams have 20 m.
  constexpr double least_track_radius = 20;

  /// What turns the wheel.
  enum class Drive
  {
    torque, ///< constant torque: traction coefficient x static wheel load x rolling radius
    rate    ///< pitch rate held at the prescribed creepage
  };

  /// What a run begins with, of the steady rolling that the half-space theory predicts.
  enum class StartState
  {
    steady_rolling,     ///< creepage, tractions, and the velocities of fields that travel with the contact
    without_creepage,   ///< the wheel turns at V / R
    without_tractions,  ///< no shear traction
    without_velocities, ///< rail at rest, wheel turning as a rigid body
    normal_load         ///< none of the three
  };

  /// Where the finest cells lie.
  enum class MeshWindow
  {
    fixed, ///< all along the rolled distance
    moving ///< around the wheel
  };

  /// What becomes of finest cells that the wheel has left behind.
  enum class BehindWheel
  {
    automatic, ///< those that have flowed stay, the others are made coarse
    coarsen,   ///< all are made coarse
    keep       ///< all stay
  };

  /// Which wheel passes when one has passed before.
  enum class NextWheel
  {
    fresh, ///< a new one
    same   ///< the one before, with what it has yielded
  };

  /// What the commands for half-spaces take wheel and rail for.
  enum class ContactBodies
  {
    half_spaces, ///< Kalker's theory
    real,        ///< this wheel on its bore and this rail on its foot, doc/theory/bodies.md
    automatic    ///< real, or half-spaces where these cannot be: commands decide, see solve_with_bodies()
  };

  /// Where the rigid slip of the half-space contact comes from.
  enum class HalfspaceSpin
  {
    local_radius, ///< every slice rolls with its own radius and inclination
    contact       ///< one creepage and one spin, as in Kalker's program CONTACT
  };

  /// The running surface of a roller, or of a straight bar.
  struct RollerShape
  {
    double radius = 0; ///< in the rolling direction [m], 0: straight
    double crown  = 0; ///< radius across [m], 0: flat, negative: that of the file in Profiles/Wheel or /Rail
  };

  /// All values of one scene in SI units, as read from a .prm file.
  struct Scene
  {
    std::string title;

    // Profiles, Track, Wheelset
    std::string        wheel_profile      = "S1002"; ///< standard profile or file
    std::string        rail_profile       = "54E1";
    std::string        left_wheel_profile = "as right"; ///< of a whole wheelset
    std::string        left_rail_profile  = "as right";
    ProfileFileOptions wheel_file{ProfileKind::wheel}; ///< how files are read
    WheelOrigin        wheel_origin = WheelOrigin::automatic;
    ProfileFileOptions rail_file{ProfileKind::rail};
    std::string        rail_body   = "auto"; ///< standard rail below a measured head
    std::string        second_rail = "none"; ///< file of slices of another rail under the same wheel, or none
    double             rail_place  = 0;      ///< along rails by slices, where the path begins [m]
    TrackDimensions    track; ///< flange-back distance and nominal radius belong to Wheelset in the file
    double             rail_length = 1.8; ///< [m]
    SupportData        support;           ///< what the rail stands on
    double             track_radius =
      std::numeric_limits<double>::infinity(); ///< of a curve to the left; negative: right [m]
    WheelDimensions wheel;                     ///< Wheelset/Rim width, ... [m]
    bool            left_wheel  = false;       ///< the modelled one; seen as its mirror image
    bool            both_wheels = false;       ///< of the wheelset, in half-spaces
    bool            rigid_axle  = true;        ///< both wheels on it turn at one rate
    bool   pose_balances        = false; ///< lateral shift and yaw are found from the forces on the wheelset
    double lateral_stiffness    = 0;     ///< that holds the wheelset then [N/m]
    double yaw_stiffness        = 0;     ///< [N m/rad]
    double centre_height        = 1.8;   ///< of the centre of gravity above the rails [m]
    double cant = std::numeric_limits<double>::infinity(); ///< right rail above the left [m]; infinite: none
    double prudhomme_factor       = 1;                     ///< k of the limit of the sum of lateral forces
    double lateral_shift          = 0;                     ///< [m]
    RollMode roll                 = RollMode::none;
    double   roll_angle           = 0;         ///< with RollMode::given, from X to Y [rad]
    double   yaw                  = 0;         ///< angle of attack, from Z to X [rad]
    double   lateral_creepage     = 0;         ///< lateral velocity of the wheelset along X over `velocity`
    double   sprung_mass          = 10000;     ///< [kg]
    double   wheel_load           = 0;         ///< [N], 0: from the sprung mass
    double   axle_mass            = 180;       ///< half axle, rigid [kg]
    double   axle_pitch_inertia   = 1.5;       ///< half axle about its own axis [kg m2]
    double   suspension_stiffness = 1.15e6;    ///< [N/m]
    double   suspension_damping   = 2500;      ///< [N s/m]
    double   velocity             = 140 / 3.6; ///< [m/s]
    Drive    drive                = Drive::torque;
    double   traction_coefficient = 0;
    double   creepage             = 0; ///< used with Drive::rate, positive driving

    std::string motion = "none"; ///< file of a motion that the run follows, or none
    double      motion_start =
      std::numeric_limits<double>::infinity(); ///< place there [m]; infinite: its first row

    // Contact
    FrictionLaw friction = {0.5, FrictionKind::constant, 0.4, 0.05, 15}; ///< between wheel and rail
    double      left_friction =
      std::numeric_limits<double>::infinity(); ///< at rest, of the left rail; infinite: as the other
    double penalty_scale   = 10;               ///< effective scale f: eps = f K / h
    double contact_damping = 0.3;              ///< fraction of critical
    bool   surface_filter  = true;             ///< corrects the surface response of the mesh

    MaterialData rail_material, wheel_material;

    // Mesh
    double      cell_size        = 1e-3;  ///< Solution cell size [m]
    double      coarse_cell_size = 16e-3; ///< [m]
    double      fine_depth       = 0; ///< given depth of the finest cells [m], 0: see depth_of_fine_cells()
    double      fine_margin      = 3e-3; ///< fine cells beyond the expected patch [m] ("Fine margin")
    ElementForm element          = ElementForm::reduced;
    std::optional<ElementForm> rail_element, wheel_element; ///< none: as `element`
    MeshWindow                 window       = MeshWindow::moving;
    BehindWheel                behind_wheel = BehindWheel::automatic;
    double              planned_load = 0; ///< for whose patch fine cells are laid [N], 0: the wheel load
    std::vector<double> planned_strip;    ///< rail section x, fine cells between [m]; none: around the patch
    double prepared_distance = 0; ///< the mesh is made for rolling that far [m], 0: the rolling distance

    // Run
    static constexpr double at_largest_force = -1; ///< for evaluate_at: around the largest vertical force

    StartState   start              = StartState::steady_rolling;
    double       rolling_distance   = 0.06; ///< [m], 0: until steady
    double       longest_distance   = 0.06; ///< of a run until steady [m]
    double       standard_error     = 1e-3; ///< that its results may have, over their scales (see Steadiness)
    double       wanted_accuracy    = 0.05; ///< share within which intervals and gaps of models are trusted
    double       averaging_distance = 0.02; ///< stretch over which the figures are means [m]
    double       evaluate_at        = 0;    ///< its middle [m]; 0: it is the last one
    double       time_step_factor   = 0.95; ///< fraction of the stable step
    double       bulk_viscosity     = 0.06; ///< linear bulk viscosity coefficient
    unsigned int passages           = 1;    ///< how often the wheels go over the same rail; 0: until steady
    unsigned int most_passages      = 50;   ///< of wheels, until steady
    double       settled_growth     = 1e-5; ///< of strain in a round, below which nothing grows any more
    double       settled_change     = 0.03; ///< of the growth from round to round, below which it is steady
    std::string  passage_list       = "none"; ///< file of the wheels of a round, or none: one as the scene
    NextWheel    next_wheel         = NextWheel::fresh;
    std::string  rail_from          = "new"; ///< folder of the run that left the rail, or new
    double       start_offset       = 0;     ///< how much farther along the rail the wheel starts [m]
    unsigned int staggered_starts   = 0;     ///< places where passages start, 0: two where there is room
    double       gravity            = 9.81;  ///< [m/s2]
    double       energy_limit       = 0.005; ///< energy error at which the run stops

    // Output
    std::string  folder              = "output/scene";
    unsigned int ticks               = 20; ///< evenly spaced outputs of patch and surface fields over the run
    bool         volume_fields       = true; ///< VTU of the whole mesh at start and end
    double       checkpoint_interval = 0;    ///< between two saved states [s], 0: see SavedStates

    // Half-space
    double        halfspace_element_size   = 0.4e-3; ///< [m]
    ContactBodies halfspace_bodies         = ContactBodies::automatic;
    HalfspaceSpin halfspace_spin           = HalfspaceSpin::local_radius;
    bool          halfspace_section_normal = false; ///< of rails by slices: turned about the track alone
    double halfspace_given_spin = std::numeric_limits<double>::infinity(); ///< [1/m]; infinite: of the wheel
    double halfspace_memory_length      = 0;     ///< slip distance of the friction's memory, 0: none [m]
    double halfspace_memory_speed       = 1e-3;  ///< its least slip velocity [m/s]
    double halfspace_layer_thickness    = 0;     ///< of an interface layer, 0: none [m]
    double halfspace_layer_shear        = 8.2e9; ///< its shear modulus [Pa]
    double halfspace_lateral            = 0; ///< wheel section moved against the rail to the track centre [m]
    double halfspace_inclination        = 0; ///< rail head turned to the track centre [rad]
    std::string halfspace_distance      = "profiles"; ///< profiles, hertz, rollers, or a file of distances
    double      halfspace_radius_along  = 0.46;       ///< Hertzian distance: relative radii [m]
    double      halfspace_radius_across = 0.3;
    RollerShape wheel_roller{0.46}; ///< the rollers of a test rig
    RollerShape rail_roller;
    double      roller_width            = 10e-3; ///< of the narrower one [m]
    double      halfspace_normal_force  = 0;     ///< [N], 0: the static wheel load
    double      halfspace_approach      = 0;     ///< [m], 0: found from the normal force
    double      halfspace_contact_angle = 0;     ///< of the axle to the contact plane: the spin [rad]

    std::array<IrregularityData, most_irregularities> irregularities; ///< of the running surfaces

    WearData wear;      ///< laws of wear and cracks
    WearPlan wear_plan; ///< for the command wear

    MaterialTest material_test; ///< for the command material

    Study study; ///< the family that this scene stands for, for the command study

    /// Depth of the layer of solution cells below both running surfaces: as given, or five cells [m].
    double
    depth_of_fine_cells() const
    {
      return fine_depth > 0 ? fine_depth : 5 * cell_size;
    }

    /// Those of Wheelset, with the nominal radius of the track.
    WheelDimensions
    wheel_dimensions() const
    {
      WheelDimensions dimensions = wheel;
      dimensions.nominal_radius  = track.nominal_radius;
      return dimensions;
    }

    /// How far the wheel rolls, at most where the run ends by itself [m].
    double
    path() const
    {
      return rolling_distance > 0 ? rolling_distance : longest_distance;
    }

    /// Whether the run ends as soon as its results are steady and known. Passages are compared at one place
    /// that all of them roll over, and a motion that is followed is never steady, nor is a wheel on irregular
    /// surfaces: these roll their path.
    bool
    until_steady() const
    {
      return rolling_distance == 0 && motion == "none" && !several_passages() && !irregular();
    }

    /// How far the mesh lets the wheel roll [m].
    double
    mesh_distance() const
    {
      return prepared_distance > 0 ? prepared_distance : path();
    }

    /// Whether the section of the rail changes along the track.
    bool
    rail_by_slices() const
    {
      return is_slices_file(rail_profile);
    }

    /// Whether a running surface is not the same all along: rail or wheel has an irregularity, or the rail is
    /// given by slices.
    bool
    irregular() const
    {
      if (rail_by_slices())
        return true;
      for (const IrregularityData &one : irregularities)
        if (one.kind != IrregularKind::none)
          return true;
      return false;
    }

    /// Whether more than one wheel passes, or wheels of a list.
    bool
    several_passages() const
    {
      return passages != 1 || passage_list != "none";
    }
  };

  /// Where the wheelset of a scene stands in its track, seen from the modelled wheel: a left one as its
  /// mirror image, in which X points to the track centre again.
  inline WheelsetPose
  wheelset_pose(const Scene &scene)
  {
    const WheelsetPose pose{scene.lateral_shift, scene.roll, scene.roll_angle, scene.yaw};
    return scene.left_wheel ? mirrored(pose) : pose;
  }

  /// Lateral velocity of the wheelset over its velocity, seen likewise.
  inline double
  lateral_creepage(const Scene &scene)
  {
    return scene.left_wheel ? -scene.lateral_creepage : scene.lateral_creepage;
  }

  /// Curvature of the wheelset's path, seen likewise: positive with the centre on the side of +X, where the
  /// modelled wheel is the outer one [1/m].
  inline double
  path_curvature(const Scene &scene)
  {
    return (scene.left_wheel ? -1 : 1) / scene.track_radius;
  }
} // namespace wheelrail
