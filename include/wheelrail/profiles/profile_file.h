#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/profiles/profile_formats.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Unit of the coordinates in a profile file.
  enum class ProfileUnit
  {
    automatic, ///< as the file states, or mm or m if the profile then is 30 mm to 300 mm across
    millimetre,
    metre,
    inch
  };

  /// Whether a coordinate is turned to the other side.
  enum class ProfileMirror
  {
    automatic, ///< as the shape says; sides of rails by the habit of the format
    yes,
    no
  };

  /// Where the lateral origin of a wheel file lies.
  enum class WheelOrigin
  {
    automatic, ///< by the flange back or the flange tip
    running_circle,
    flange_back
  };

  /// How a profile file is read.
  struct ProfileFileOptions
  {
    ProfileKind   kind   = ProfileKind::rail;
    ProfileMirror mirror = ProfileMirror::automatic; ///< x
    ProfileMirror turn   = ProfileMirror::automatic; ///< y
    ProfileUnit   unit   = ProfileUnit::automatic;
    double        noise  = -1;    ///< standard deviation to smooth away [m]; negative: that of the points
    bool          roller = false; ///< the crown of a test rig's roller, without flange or gauge side
    bool          placed = false; ///< the scene says where its origin lies: flange or sides may lack
  };

  /// A profile from a file, checked, turned, cleaned and smoothed.
  struct MeasuredProfile
  {
    ProfileKind              kind = ProfileKind::rail;
    std::string              file;
    std::vector<FilePoint>   points;    ///< cleaned, in the order of the curve [m]
    Curve                    curve;     ///< smoothed; from the field side to the gauge side or flange back
    double                   noise = 0; ///< median standard deviation that was smoothed away [m]
    std::vector<double>      deviation; ///< that of each point [m]
    std::vector<std::size_t> kinks;     ///< points at which the curve has two tangents
    bool                     placed = false; ///< by the scene, see ProfileFileOptions
    bool                     crown  = false; ///< and without flange or sides
    std::vector<std::string> notes;          ///< what was found and what was done, one sentence each
  };

  /// Whether a value that may be a name of the program's own (of a standard profile, say) means a file: it
  /// has a dot or a slash, which no such name has.
  bool
  is_file_name(const std::string &name);

  /// Reads a wheel or rail profile (SIMPACK, MiniProf, two columns; profile_formats.h) and turns it
  /// into x positive to the field side, y up, running from the field side to the gauge side (rail:
  /// the head down to at most 35 mm below its top) or to the flange back (wheel). The origin stays
  /// that of the file; measured_rail() and measured_wheel() move it. The crown of a roller runs from its
  /// largest x to its smallest, y pointing out of the roller, as do crowns without flange or sides, y up.
  ///
  /// Throws InputError that names the file, the line where one is to blame, what was found, what is
  /// accepted and what to do. Returns or throws for any bytes in a time that their number bounds.
  MeasuredProfile
  read_profile_file(const std::string &path, const ProfileFileOptions &options);

  /// The same for the text of a file; `file` only names it.
  MeasuredProfile
  read_profile_text(const std::string &text, const std::string &file, const ProfileFileOptions &options);

  /// The profile with another of the curves that its points leave possible, see smoothing_spline().
  MeasuredProfile
  drawn(MeasuredProfile profile, unsigned int draw);

  /// Whether a path is that of a file of slices along the track or around the wheel (.slcs, .slcw).
  bool
  is_slices_file(const std::string &path);

  /// The files of the slices that such a file names.
  std::vector<std::string>
  files_of_slices(const std::string &path);
} // namespace wheelrail
