#pragma once

#include <wheelrail/bodies/body_influence.h>
#include <wheelrail/bodies/body_tables.h>
#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/planes/contact_sections.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <array>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// Steady rolling of this wheel on this rail, as elastic bodies: half-spaces unfolded along the rail's
  /// profile, and what the bodies deflect beyond them. Conformal: at each place across the rail pressure
  /// acts along the rail's own normal there. Where head and rim turn and move to under the load follows, and
  /// with it where the surfaces meet and in which direction pressure acts; nothing is fitted.
  class BodyContact
  {
  public:
    /// Scene, geometry and tables must outlive it.
    BodyContact(const Scene &scene, const SceneGeometry &geometry, const BodyTables &tables);

    /// Finds pressure and tractions under a load that presses vertically (of one that presses along the
    /// normal, its vertical component at the first contact point): both in turns, with the vertical part of
    /// the tractions and the stretch of the tread taken from the round before.
    void
    carry(const WheelRailLoad &load);

    /// How much more the tread is stretched along the track than the head, by pressure and turning alone, as
    /// tread_stretch() of the static start has it [-]. For a contact that has not carried anything yet.
    double
    stretch_under_pressure(const WheelRailLoad &load);

    /// That keeps the wheel turning as it rolled last [N m].
    double
    torque() const;

    /// In the form of half-spaces; lateral coordinates are the arc along the rail's profile from the first
    /// contact point [m].
    WheelRailSolution
    result() const;

  private:
    /// A row of elements along the track.
    struct Row
    {
      bool   touches = false;             ///< both surfaces are there
      Point2 place;                       ///< on the rail, in the track plane [m]
      double angle    = 0;                ///< of the rail's tangent against X, turned [rad]
      double rail_arc = 0, wheel_arc = 0; ///< along the profiles [m]
      double distance     = 0;      ///< of the wheel along the rail's normal, after the lateral motion [m]
      double along_normal = 1;      ///< that over one along the normal of the first contact point
      double s            = 0;      ///< of the wheel in the frame of that point [m]
      ContactSections::Slice slice; ///< of the wheel there
    };

    /// How the bodies' own motion moves the surfaces of a row, beyond what half-spaces do.
    struct RowMotion
    {
      double turn     = 0; ///< of the rail's surface, as angles count [rad]
      double shift    = 0; ///< of the wheel's surface against the rail's, along the rail's tangent [m]
      double rim_turn = 0; ///< of the wheel's [rad]
    };

    /// By the solution, of each row of elements.
    std::vector<RowMotion>
    row_motions() const;

    /// Between rows; 0 before anything has moved.
    RowMotion
    motion_at(double y) const;

    /// Puts the rows where the solution moves them to; the largest change over what counts as settled.
    double
    move_rows();

    Row
    row_at(double y) const;

    /// A grid of elements [m] over the places where the undeformed surfaces are closer than `reached` [m].
    void
    lay_grid(double element, double reached);

    void
    set_bodies();

    void
    set_slip();

    /// One solution with what the last one adds to slip, load and gap; the largest change of rigid slip,
    /// pressure and motion of the surfaces over what counts as settled.
    double
    solve_round(const WheelRailLoad &load);

    /// Rounds, on a grid that grows, until changes are below `loosely` times what counts as settled;
    /// tangential problems to the tolerance. False: they did not get there.
    bool
    settle(const WheelRailLoad &load, double tolerance, double loosely);

    /// From a coarser grid to the elements asked for, with its solution to begin with.
    void
    refine();

    /// What the wheel has to be borne with [N].
    double
    vertical_load(const WheelRailLoad &load) const;

    /// Of the solution: along x and y, pressure.
    RowsInfluence::Given
    tractions() const;

    /// How much the wheel's surface is moved upwards, by tractions and by turning [m].
    std::vector<double>
    wheel_rise(const RowsInfluence::Given &tractions) const;

    /// The same under the pressure of the solution.
    double
    stretch_of_tread() const;

    BodyLoads
    loads(bool on_wheel) const;

    /// Of the elements, on the wheelset.
    WheelsetForces
    forces_on_wheelset() const;

    /// Force on the wheel: along X, upwards [N].
    Point2
    force() const;

    const SceneGeometry &geometry_;
    const BodyTables    &tables_;
    ContactSections      sections_;
    double first_ = 0, first_arc_ = 0; ///< of the rail's profile at the first contact: parameter, arc [m]
    WheelMotion            motion_;
    double                 element_ = 0, rate_ = 0; ///< [m], of turning [rad/s]
    double                 tolerance_ = 0;          ///< of tangential problems
    double                 reached_   = 0;          ///< distance up to which the grid reaches [m]
    std::vector<Row>       rows_;
    std::vector<RowMotion> motions_; ///< of the rows; empty before anything has moved
    HalfspaceProblem       problem_;
    HalfspaceSolution      solution_;
    std::vector<double>    own_slip_; ///< rigid slip along the track without the tread's stretch
    std::vector<Point2>    growth_;   ///< of each row [m]
    std::vector<double>    rise_;     ///< of the last round [m]

    std::array<ContactRows, 2> contact_rows_; ///< of the tables of rail and wheel

    std::shared_ptr<RowsInfluence>    added_;
    std::shared_ptr<HalfspaceKernels> kernels_, wheel_kernels_;
    int                               enlargements_ = 0, rounds_ = 0;
  };

  /// solve_wheel_rail() with the true bodies.
  WheelRailSolution
  solve_bodies(const Scene         &scene,
               const SceneGeometry &geometry,
               const WheelRailLoad &load,
               const BodyTables    &tables);

  /// Steady rolling of one wheel on its rail by what Half-space/Bodies names: the true bodies
  /// (solve_bodies()), without offsets, or half-spaces (solve_halfspaces()). `time` is set.
  WheelRailSolution
  solve_wheel_rail(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets);
} // namespace wheelrail
