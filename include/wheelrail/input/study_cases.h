#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// One scene of a study.
  struct StudyCase
  {
    std::vector<std::string> values; ///< one an axis, as the listing writes it: "-5.5 mm"
    std::string              name;   ///< of its output folder, below that of the study
    Scene                    scene;  ///< with that folder and no study of its own
  };

  /// What makes a study impossible though each of its axes is right by itself, one sentence each, starting
  /// with the entry: axes of different lengths as pairs, a case twice, too many cases. Nothing for a scene
  /// without axes.
  std::vector<std::string>
  study_faults(const Scene &scene);

  /// The cases of a study without faults, the values of the last axis changing fastest. Equal scenes have
  /// equal names under one version of the program, wherever they stand: a name ends with a digest of the
  /// version, of all entries but those that only name or save (title, folder, checkpoint interval) and of
  /// the files that entries name.
  std::vector<StudyCase>
  study_cases(const Scene &scene, const std::string &program_version);
} // namespace wheelrail
