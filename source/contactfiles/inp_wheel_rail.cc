#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/inp_groups.h>

#include <algorithm>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    /// The path of a file that an input file names: both slashes separate folders, and it counts from the
    /// folder of that file.
    std::string
    path_beside(const std::string &inp_file, std::string name)
    {
      std::replace(name.begin(), name.end(), '\\', '/');
      return (std::filesystem::path(inp_file).parent_path() / name).lexically_normal().string();
    }

    ContactProfile
    read_profile(InpWords &words, const std::string &inp_file, const char *name)
    {
      const InpGroup group =
        words.group("'" + std::string(name) + " #MIRRORY SCALE SMOOTH {#MIRRORZ} {#PRFOPT}");
      ContactProfile profile;
      profile.line      = group.line;
      profile.file      = path_beside(inp_file, group.text);
      profile.mirror_y  = int(group.values[0]);
      profile.scale     = group.values[1];
      profile.smoothing = group.values[2];
      profile.mirror_z  = int(group.value(3));
      profile.options   = int(group.value(4));
      std::error_code ignored;
      if (!std::filesystem::exists(profile.file, ignored))
        words.fail(group.line,
                   "the profile \"" + group.text + "\" is not there: no file " + profile.file +
                     "; paths of profiles count from the folder of the input file");
      if (const std::string other = other_than_a_file(profile.file); !other.empty())
        words.fail(group.line, "the profile \"" + group.text + "\" is no file, but " + other);
      if (profile.scale <= 0)
        words.fail(group.line, "SCALE of a profile is not positive");
      if (profile.options >= 1)
        {
          const auto v             = words.group("#ISMOOTH @ZIGTHRS @KINKHIGH @KINKLOW KINKWID").values;
          profile.smoothing_method = int(v[0]);
          profile.zigzag           = v[1];
          profile.kink_high        = v[2];
          profile.kink_low         = v[3];
          profile.kink_width       = v[4];
        }
      if (profile.options >= 2)
        {
          const auto v           = words.group("#ERRHND MAXOMIT").values;
          profile.error_handling = int(v[0]);
          profile.largest_gap    = v[1];
        }
      return profile;
    }

    void
    read_elements(InpWords &words, ContactCase &one)
    {
      const InpGroup group = words.group("DX DS DQREL @A_SEP D_SEP D_COMB {D_TURN} {G_MISS}");
      const auto    &v     = group.values;
      one.elements         = {
                v[0], v[1], v[2], v[3], v[4], v[5], group.value(6, 2 * v[4] - v[5]), group.value(7, -1), group.line};
      if (v[0] <= 0 || v[1] <= 0 || v[2] <= 0)
        words.fail(group.line, "DX, DS and DQREL, the size of the elements and of a step, are not positive");
    }

    void
    read_track(InpWords &words, ContactCase &one)
    {
      const int     written = one.written.geometry;
      const bool    roller  = one.digits.side >= 4;
      ContactTrack &track   = one.track;
      if (written == 1 || written == 3)
        {
          const InpGroup group = words.group(std::string("GAUGHT GAUGSQ|RAILY0 GAUGWD|RAILZ0 ") +
                                             (roller ? "NOMRADR {CURV}" : "@CANT {CURV}"));
          const auto    &v     = group.values;
          const bool     gauge = v[0] > 0;
          track.gauge_height   = v[0];
          track.gauge_sequence = gauge ? v[1] : 0;
          track.gauge          = gauge ? v[2] : 0;
          track.rail_y         = gauge ? 0 : v[1];
          track.rail_z         = gauge ? 0 : v[2];
          track.cant           = roller ? 0 : v[3];
          track.roller_radius  = roller ? v[3] : 0;
          track.curvature      = group.value(4);
          track.line           = group.line;
        }
      if (written == 3)
        track.profile = read_profile(words, one.file, "RFNAME");
      if (written == 2 || written == 3)
        {
          const InpGroup group = words.group("DYRAIL DZRAIL @DROLLR VYRAIL VZRAIL @VROLLR");
          std::copy(group.values.begin(), group.values.end(), track.deviation.begin());
          track.deviation_line = group.line;
          if (one.digits.forces == 3)
            track.springs = words.group("KYRAIL FYRAIL KZRAIL FZRAIL {DYSTEP0}").values;
        }
    }

    void
    read_wheelset(InpWords &words, ContactCase &one)
    {
      const int        written  = one.written.extra;
      const bool       roller   = one.digits.side >= 4;
      ContactWheelset &wheelset = one.wheelset;
      if (written == 3 || written == 5)
        {
          const InpGroup group     = words.group("FBDIST FBPOS NOMRADW {YTAPE}");
          wheelset.flange_distance = group.values[0];
          wheelset.flange_place    = group.values[1];
          wheelset.radius          = group.values[2];
          wheelset.tape_place.assign(group.values.begin() + 3, group.values.end());
          wheelset.line    = group.line;
          wheelset.profile = read_profile(words, one.file, "WFNAME");
        }
      if (written >= 1)
        {
          const InpGroup group = words.group(std::string(roller ? "X Y " : "S Y ") +
                                             (one.digits.normal == 1 ? "FZ" : "Z") + " @ROLL @YAW @PITCH");
          std::copy(group.values.begin(), group.values.end(), wheelset.position.begin());
          wheelset.position_line = group.line;
          if (one.digits.normal == 1 && group.values[2] < 0)
            words.fail(group.line,
                       "FZ is negative; a force that presses wheel and rail together counts positive");
        }
      if (written >= 2)
        {
          const InpGroup group = words.group(std::string(roller ? "RPITCH" : "VS") + " VY VZ @VROLL @VYAW " +
                                             (one.digits.forces == 1 ? "FX_WS" : "@VPITCH"));
          std::copy(group.values.begin(), group.values.end(), wheelset.velocity.begin());
          wheelset.velocity_line = group.line;
        }
      if (written >= 4)
        {
          const InpGroup place = words.group("DXWHL DYWHL DZWHL @DROLLW @DYAWW @DPITCHW");
          const InpGroup speed = words.group("VXWHL VYWHL VZWHL @VROLLW @VYAWW @VPITCHW");
          std::copy(place.values.begin(), place.values.end(), wheelset.flexible.begin());
          std::copy(speed.values.begin(), speed.values.end(), wheelset.flexible.begin() + 6);
        }
    }
  } // namespace


  void
  read_wheel_rail_groups(InpWords &words, ContactCase &one)
  {
    if (one.written.grid >= 2)
      read_elements(words, one);
    read_track(words, one);
    read_wheelset(words, one);
  }
} // namespace wheelrail
