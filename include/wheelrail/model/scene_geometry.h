#pragma once

#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What was read of files; none of standard profiles.
  struct FileProfiles
  {
    std::optional<MeasuredProfile> rail, wheel;
  };

  /// The rail and the wheel of a scene, standard ones or read from files (measured_profiles.h).
  struct SceneProfiles
  {
    RailProfile  rail;
    WheelProfile wheel;
    std::vector<std::string>
                 notes; ///< what was found in files and done to them, with entry and file in front
    FileProfiles files = {};
  };

  /// All that follows from profiles and track of a scene alone. A command makes it once and hands it to
  /// whatever needs profiles: checks, model, half-spaces, texts.
  struct SceneGeometry : TouchingProfiles
  {
    std::vector<std::string> notes; ///< as those of the profiles
    FileProfiles             files = {};
  };

  /// Reads and smooths the profiles. Throws InputError that names the entry; for a rail by slices, too.
  SceneProfiles
  read_profiles(const Scene &scene);

  /// The same for a mesh, which takes a rail by slices with the section at its start (rail_slices.h).
  SceneProfiles
  read_mesh_profiles(const Scene &scene);

  /// The same of the wheel alone.
  SceneProfiles
  read_wheel_profile(const Scene &scene);

  /// Puts the profiles in touch at the scene's lateral shift, see touching_profiles(). Throws InputError when
  /// they do not touch there.
  SceneGeometry
  smooth_geometry(const Scene &scene, SceneProfiles profiles);

  /// The same with the irregularities of the scene on them. Throws InputError when a file cannot be read,
  /// too.
  SceneGeometry
  make_geometry(const Scene &scene, SceneProfiles profiles);

  /// The geometry with others of the profiles and of measured irregularities that the points of files leave
  /// possible, see drawn().
  SceneGeometry
  drawn(const Scene &scene, const SceneGeometry &geometry, unsigned int draw);

  /// Whether there are any of irregularities.
  bool
  draws_irregularities(const SceneGeometry &geometry);

  /// The surfaces with the wheel at a place along the track [m] and at a pitch [rad].
  SceneGeometry
  standing(SceneGeometry geometry, double place, double pitch);

  /// Of read_mesh_profiles().
  SceneGeometry
  make_geometry(const Scene &scene);

  /// One wheel of the wheelset of a scene: that of its side, with profiles and friction of its own.
  Scene
  wheel_of_wheelset(const Scene &scene, bool left);

  /// Profiles of both sides.
  struct WheelsetProfiles
  {
    SceneProfiles right, left;
  };

  /// Reads those of a wheelset, or twice those of the wheel that is modelled. Throws InputError as
  /// read_profiles().
  WheelsetProfiles
  read_wheelset_profiles(const Scene &scene);
} // namespace wheelrail
