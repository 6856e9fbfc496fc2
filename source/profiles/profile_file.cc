#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/profile_cleaning.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/profiles/profile_orientation.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    const char *
    word(const ProfileKind kind)
    {
      return kind == ProfileKind::rail ? "rail" : "wheel";
    }

    const char *
    entry(const ProfileKind kind)
    {
      return kind == ProfileKind::rail ? "Profiles/Rail" : "Profiles/Wheel";
    }

    std::string
    read_text(const std::string &path)
    {
      namespace fs = std::filesystem;
      std::error_code error;
      const auto      status = fs::status(path, error);
      if (!fs::exists(status))
        throw InputError(
          path + ": no such file; profiles are looked for where the command is given, then beside the scene");
      if (!fs::is_regular_file(status))
        throw InputError(path +
                         ": not a file; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
      if (fs::file_size(path, error) > largest_profile_file && !error)
        throw InputError(path + ": larger than " + std::to_string(largest_profile_file / 1000000) +
                         " MB; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
      std::ifstream      file(path, std::ios::binary);
      std::ostringstream text;
      if (!file || (fs::file_size(path, error) > 0 && !(text << file.rdbuf())))
        throw InputError(path + ": cannot be read; check its permissions");
      return text.str();
    }

    void
    check_kind(const FileContent &content, const std::string &file, const ProfileKind kind)
    {
      if (content.kind_stated && content.kind != kind)
        throw InputError(place(file, content.kind_line) +
                         "type = " + (content.kind == ProfileKind::wheel ? "1, a wheel" : "0, a rail") +
                         "; " + entry(kind) + " needs a " + word(kind) + " profile");
    }

    /// Metres per unit of the file, by the option, the file or the size of the profile.
    double
    find_unit(const FileContent        &content,
              const std::string        &file,
              const ProfileFileOptions &options,
              std::vector<std::string> &notes)
    {
      const std::string name = std::string(entry(options.kind)) + " unit";
      const auto        text = [](const double unit) {
        return unit == 1        ? std::string("m")
                      : unit == 0.0254 ? "inch"
                      : unit == 1e-3   ? "mm"
                                       : in_mm(unit, 1e6);
      };
      if (options.unit != ProfileUnit::automatic)
        {
          const double unit = options.unit == ProfileUnit::metre  ? 1
                              : options.unit == ProfileUnit::inch ? 0.0254
                                                                  : 1e-3;
          notes.push_back("unit " + text(unit) + " by " + name +
                          (content.metres_per_unit > 0 && content.metres_per_unit != unit
                             ? ", though the file states " + text(content.metres_per_unit)
                             : ""));
          return unit;
        }
      if (content.metres_per_unit > 0)
        {
          notes.push_back("unit " + text(content.metres_per_unit) + " as the file states");
          return content.metres_per_unit;
        }
      double low = content.points[0].position.x, high = low;
      for (const FilePoint &p : content.points)
        {
          low  = std::min(low, p.position.x);
          high = std::max(high, p.position.x);
        }
      const std::string width = format_number(std::round((high - low) * 1e4) / 1e4);
      for (const double unit : {1e-3, 1.})
        if (const double across = (high - low) * unit; across >= 0.03 && across <= 0.3)
          {
            notes.push_back("unit taken as " + text(unit) + ", since the profile then is " +
                            in_mm(across, 10) + " wide; " + name + " changes it");
            return unit;
          }
      throw InputError(file + ": the profile is " + width +
                       " units wide and the file states none; as mm or m it is not a " + word(options.kind) +
                       " (30 mm to 300 mm): set " + name + " to mm, m or inch, or scale the file");
    }

    void
    check_scatter(const std::vector<Point2> &points, const std::string &file)
    {
      constexpr double          most    = 3e-4;
      const std::vector<double> scatter = estimated_scatter(points);
      const double              least   = *std::min_element(scatter.begin(), scatter.end()); // that of all
      if (least > most)
        throw InputError(file + ": the points scatter by " + in_mm(least) +
                         " about a smooth line, which is no measured profile (up to " + in_mm(most) +
                         " is smoothed): measure again, or set Profiles/Smoothing");
    }

    /// The smoothing knows points only: its messages get the name of the file.
    Curve
    smoothed(const MeasuredProfile &profile, const unsigned int draw)
    {
      try
        {
          return Curve(smoothing_spline(positions(profile.points), profile.kinks, profile.deviation, draw));
        }
      catch (const InputError &error)
        {
          throw InputError(profile.file + ": " + error.what());
        }
    }

    /// The curve through the points, with notes on what was done.
    void
    smooth(MeasuredProfile &profile, const bool by_entry)
    {
      const std::vector<Point2> points = positions(profile.points);
      profile.kinks                    = find_kinks(points, profile.deviation);
      profile.curve                    = smoothed(profile, 0);
      profile.noise                    = median(profile.deviation);
      double worst                     = 0;
      for (const Point2 &p : points)
        worst = std::max(worst, norm(profile.curve.at(profile.curve.closest(p)).position - p));
      if (!(worst < 1e-3))
        throw InputError(
          profile.file + ": the smoothed profile lies up to " + in_mm(worst) +
          " off the points; up to 1 mm is accepted: set Profiles/Smoothing to a smaller length");
      const auto um = [](const double length) {
        return format_number(std::round(length * 1e8) / 100) + " um";
      };
      profile.notes.push_back("noise of " + um(profile.noise) +
                              (by_entry ? " by Profiles/Smoothing" : " found in the points") +
                              " smoothed; the curve lies at most " + um(worst) + " off the points");
      for (const std::size_t k : profile.kinks)
        profile.notes.push_back("kink at x = " + in_mm(points[k].x, 10) + ", y = " + in_mm(points[k].y, 10) +
                                " kept");
    }

    /// Turned as its kind is, a crown as its format is or as asked: y out of a roller, else up.
    std::vector<FilePoint>
    oriented(std::vector<FilePoint>    points,
             const FileContent        &content,
             const std::string        &file,
             const ProfileFileOptions &options,
             MeasuredProfile          &profile)
    {
      const bool wheel = options.kind == ProfileKind::wheel, asked = options.turn != ProfileMirror::automatic;
      const bool down =
        asked ? options.turn == ProfileMirror::yes : content.down && !(options.roller && wheel);
      const std::string turned = !down   ? ""
                                 : asked ? "as Profiles asks"
                                         : "in files of this format y points down";
      if (options.roller)
        return oriented_crown(std::move(points), turned, ProfileMirror::no, 1, profile.notes);
      if (options.placed)
        {
          std::vector<FilePoint> upright = points;
          for (FilePoint &p : upright)
            p.position.y *= down ? -1 : 1;
          profile.crown = is_crown(upright, options.kind);
        }
      if (profile.crown)
        return oriented_crown(std::move(points), turned, options.mirror, wheel ? -1 : 1, profile.notes);
      return wheel
               ? oriented_wheel(std::move(points), file, options.mirror, options.turn, profile.notes)
               : oriented_rail(
                   std::move(points), file, options.mirror, options.turn, content.gauge_right, profile.notes);
    }
  } // namespace


  bool
  is_file_name(const std::string &name)
  {
    return name.find_first_of("./") != std::string::npos;
  }


  MeasuredProfile
  read_profile_text(const std::string &text, const std::string &file, const ProfileFileOptions &options)
  {
    FileContent content = parse_profile_text(text, file);
    check_kind(content, file, options.kind);
    MeasuredProfile profile;
    profile.kind   = options.kind;
    profile.placed = options.placed;
    profile.file   = file;
    profile.notes  = {content.format + ", " + counted(content.listed, "point")};
    profile.notes.insert(profile.notes.end(), content.notes.begin(), content.notes.end());
    const double unit = find_unit(content, file, options, profile.notes);
    for (FilePoint &p : content.points)
      p.position = unit * p.position;

    std::vector<FilePoint> points    = cleaned_points(content.points, file, profile.notes);
    points                           = oriented(std::move(points), content, file, options, profile);
    profile.points                   = bridged_points(points, file, profile.notes);
    const std::vector<Point2> places = positions(profile.points);
    if (options.noise < 0)
      check_scatter(places, file);
    profile.deviation = options.noise < 0 ? deviation_of(places, unit * content.rounding)
                                          : std::vector<double>(places.size(), options.noise);
    smooth(profile, options.noise >= 0);
    return profile;
  }


  MeasuredProfile
  drawn(MeasuredProfile profile, const unsigned int draw)
  {
    profile.curve = smoothed(profile, draw);
    return profile;
  }


  MeasuredProfile
  read_profile_file(const std::string &path, const ProfileFileOptions &options)
  {
    return read_profile_text(read_text(path), path, options);
  }


  bool
  is_slices_file(const std::string &path)
  {
    const std::string ending = lower(std::filesystem::path(path).extension().string());
    return ending == ".slcs" || ending == ".slcw";
  }
} // namespace wheelrail
