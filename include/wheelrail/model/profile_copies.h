#pragma once

#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// Copies the profile files of a scene into `folder`/profiles, as wheel_NAME and rail_NAME, and the table
  /// of Wheelset/Motion as motion_NAME, so that a run can be looked at from anywhere and after its files have
  /// changed. Of slices there is a text of all that they name, to compare with. Standard profiles need none.
  /// To be called on one rank; throws RunError when they cannot be written.
  void
  keep_profiles(const Scene &scene, const std::string &folder);

  /// Whether a run can be gone on with as far as its files go: a sentence that names the first one that its
  /// steps depend on and that is no longer what `folder`/profiles has of it; empty when there is none. Files
  /// without a copy pass. Throws RunError when a file cannot be read.
  std::string
  changed_since_start(const Scene &scene, const std::string &folder);

  /// Has the scene read the copies in `folder`/profiles where there are some of its files.
  void
  use_kept_profiles(Scene &scene, const std::string &folder);
} // namespace wheelrail
