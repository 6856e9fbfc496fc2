#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// One entry of a study and the values that it takes.
  struct StudyAxis
  {
    std::string              section, name; ///< of the entry
    std::vector<std::string> values;        ///< as written, with units; the entry accepts each

    /// "Section/Name".
    std::string
    path() const
    {
      return section.empty() ? name : section + "/" + name;
    }
  };

  /// How several axes make cases.
  enum class StudyCombination
  {
    grid, ///< every value of one axis with every value of the others
    pairs ///< the first values of all axes, the second ones, ...
  };

  /// What is computed of a case.
  enum class StudyComputation
  {
    run,       ///< finite elements
    halfspace, ///< two half-spaces under the scene's own load
    both       ///< finite elements, and half-spaces under the load and in the pose of that run
  };

  /// A family of scenes that differ in a few entries.
  struct Study
  {
    std::vector<StudyAxis> axes; ///< none: a scene of its own
    StudyCombination       combine = StudyCombination::grid;
    StudyComputation       compute = StudyComputation::both;
  };
} // namespace wheelrail
