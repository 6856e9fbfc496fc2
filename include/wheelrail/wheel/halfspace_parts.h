#pragma once

#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/planes/contact_sections.h>
#include <wheelrail/scene/scene.h>

#include <functional>
#include <memory>
#include <string>

namespace wheelrail
{
  /// A problem with materials, friction law and speed of the scene; half-spaces have no yield stress. Rail
  /// as body 1.
  HalfspaceProblem
  halfspace_problem(const Scene &scene);

  /// How the scene's wheelset moves besides rolling.
  WheelMotion
  wheel_motion(const Scene &scene, const ContactGeometry &contact);

  /// The same in one plane, with the spin that the scene gives or takes from the centre of the contact.
  WheelMotion
  plane_motion(const Scene &scene, const ContactGeometry &contact);

  /// Fewest elements across a contact: fewer err by 5 % and more in the peak pressure.
  constexpr int least_elements_across = 8;

  /// Number of elements with pressure in a row through the one with the highest pressure, along or across,
  /// whichever is less; 0 without contact.
  int
  elements_across(const HalfspaceSolution &solution);

  /// Solves the normal problem alone, with `lay_grid`, which sets grid and undeformed distance for an
  /// approach and an element size [m], called with ever larger approaches until the contact keeps off the
  /// edge of the grid, `most` times beyond the first at most, and with smaller elements than `element` until
  /// least_elements_across lie across the contact or the grid would have more than 50 000. The number of
  /// enlargements comes back in `enlargements`.
  HalfspaceSolution
  solve_on_growing_grid(HalfspaceProblem                          &problem,
                        double                                     approach,
                        double                                     element,
                        int                                        most,
                        const std::function<void(double, double)> &lay_grid,
                        int                                       &enlargements,
                        std::shared_ptr<HalfspaceKernels>         &kernels);

  /// The note on the elements of a solution: that they were made smaller than those of the
  /// scene, or are still too coarse; empty otherwise.
  std::string
  resolution_note(const HalfspaceSettings &scene, const HalfspaceSolution &solution);

  /// solve_rolling(). Where friction does not carry the longitudinal force that is asked for the whole patch
  /// slides, with tractions at their bound against the slip: that of a locked wheel when braking (creepage
  /// -1), and of one that turns twice as fast, for one that spins up, when driving. `within_friction` is then
  /// false. `guess` as there.
  HalfspaceSolution
  solve_carried(const HalfspaceProblem            &problem,
                std::shared_ptr<HalfspaceKernels> &kernels,
                const HalfspaceSolution           *guess = nullptr);

  /// A solution in the layout and with the signs of a run's patch: lateral fastest, tractions on the rail
  /// (body 1), slip of the wheel against the rail.
  PatchFields
  halfspace_patch(const HalfspaceSolution &solution);

  /// T-gamma: the work of the creepages, or of friction on the paths of particles where the two are not the
  /// same, for unlike materials and true bodies [N].
  double
  wear_number(const HalfspaceProblem &problem, const HalfspaceSolution &solution);

  /// Wear across the rail (wear_profile()) of a solution as a particle passes it, from element to element
  /// (sliding_paths()): plain sums of its elements miss a part of the first power of their length.
  WearProfile
  halfspace_wear(const HalfspaceProblem  &problem,
                 const HalfspaceSolution &solution,
                 double                   velocity,
                 const WearData          &data);
} // namespace wheelrail
