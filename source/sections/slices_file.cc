#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/sections/slices_file.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

namespace wheelrail
{
  namespace
  {
    std::string
    text_of_file(const std::string &path, const std::string &named_at)
    {
      try
        {
          return read_whole_file(path);
        }
      catch (const RunError &error)
        {
          throw InputError(named_at + error.what());
        }
    }

    /// The lines of a slices file, one after the other, without comments.
    class SlicesText
    {
    public:
      explicit SlicesText(const std::string &path)
        : path_(path)
      {
        for (const Line &line : lines_of(text_of_file(path, "")))
          {
            const std::string text    = without_comment(line.text, "%");
            const std::string numbers = text.substr(0, text.find_first_not_of("0123456789+-.,eEdD \t"));
            for (std::size_t k = numbers.find(','); k != std::string::npos; k = numbers.find(',', k + 1))
              if (k > 0 && k + 1 < numbers.size() && std::isdigit(numbers[k - 1]) &&
                  std::isdigit(numbers[k + 1]))
                throw InputError(
                  place(path_, line.number) + shown(text) +
                  ": a comma between digits; write decimal points, and blanks between numbers");
            if (!text.empty())
              lines_.push_back({text, line.number});
          }
      }

      /// The next line, in which `what` is expected.
      const Line &
      next(const std::string &what)
      {
        if (next_ >= lines_.size())
          throw InputError(path_ + ": ends before " + what);
        return lines_[next_++];
      }

      /// At least `n` numbers at the begin of the next line, words after them left out.
      std::vector<double>
      numbers(const std::size_t n, const std::string &what)
      {
        const Line         &line = next(what);
        std::vector<double> values;
        for (const std::string &field : fields_of(line.text))
          if (const auto number = number_of(field); number && values.size() < n)
            values.push_back(*number);
          else
            break;
        if (values.size() < n)
          throw InputError(place(path_, line.number) + shown(line.text) + ": " + what + " is expected");
        return values;
      }

    private:
      std::string       path_;
      std::vector<Line> lines_;
      std::size_t       next_ = 0;
    };

    double
    unit_of_points(const FileContent &content, const ProfileUnit unit, const std::string &file)
    {
      if (unit != ProfileUnit::automatic)
        return unit == ProfileUnit::metre ? 1 : unit == ProfileUnit::inch ? 0.0254 : 1e-3;
      if (content.metres_per_unit > 0)
        return content.metres_per_unit;
      const auto [low, high] = std::minmax_element(
        content.points.begin(), content.points.end(), [](const FilePoint &a, const FilePoint &b) {
          return a.position.x < b.position.x;
        });
      const double width = high->position.x - low->position.x;
      for (const double metres : {1e-3, 1.})
        if (width * metres >= 0.01 && width * metres <= 0.4)
          return metres;
      throw InputError(file + ": the slice is " + wheelrail::text("%.4g", width) +
                       " units wide; as mm or m it is none (10 mm to 400 mm): set the unit of the profile");
    }

    std::vector<Point2>
    points_of_slice(const std::string &file, const std::string &named_at, const ProfileUnit unit)
    {
      const FileContent content = parse_profile_text(text_of_file(file, named_at), file);
      if (content.points.size() < 8)
        throw InputError(file + ": " + counted(content.points.size(), "point") +
                         "; a slice needs at least 8");
      const double        metres = unit_of_points(content, unit, file);
      std::vector<Point2> points;
      for (const FilePoint &p : content.points)
        {
          const Point2 q{metres * p.position.x, -metres * p.position.y};
          if (points.empty() || norm(q - points.back()) > 1e-7)
            points.push_back(q);
        }
      return points;
    }

    /// The quoted name in a line.
    std::optional<std::string>
    quoted(const std::string &text)
    {
      const auto begin = text.find_first_of("'\"");
      const auto end   = begin == std::string::npos ? begin : text.find(text[begin], begin + 1);
      if (end == std::string::npos)
        return {};
      return text.substr(begin + 1, end - begin - 1);
    }

    /// Arc lengths of the features on each slice [m].
    void
    read_features(SlicesText                &text,
                  const std::string         &path,
                  const std::size_t          n,
                  const std::vector<double> &scale,
                  Slices                    &slices)
    {
      for (std::size_t k = 0; k < slices.slices.size(); ++k)
        {
          Slices::Slice &slice = slices.slices[k];
          const auto     row   = text.numbers(
            n + 1, "place and " + std::to_string(n) + " features of slice " + std::to_string(k + 1));
          const auto fail = [&](const std::string &what) {
            throw InputError(path + ": features of slice " + std::to_string(k + 1) + ": " + what);
          };
          if (std::abs((slices.wheel ? 1 : 1e-3) * scale[1] * (scale[0] + row[0]) - slice.along) > 1e-9)
            fail("the place " + format_number(row[0]) + " is not that of the slice in the list above");
          bool   begun = false, ended = false;
          double last = 0;
          for (std::size_t f = 1; f <= n; ++f)
            {
              const double s = row[f];
              ended |= begun && s < 0;
              if (s >= 0 && ended)
                fail("feature " + std::to_string(f) +
                     " follows absent ones (-1); only leading and trailing "
                     "features may be absent");
              if (s >= 0 && begun && !(s > last))
                fail("feature " + std::to_string(f) + " does not lie behind the one before");
              begun |= s >= 0;
              last = s;
              slice.features.push_back(s < 0 ? -1 : 1e-3 * s);
            }
          if (!begun)
            fail("all are absent (-1); leave the slice out");
        }
    }

    void
    read_slices(SlicesText &text, const std::string &path, const ProfileUnit unit, Slices &slices)
    {
      const bool        wheel  = slices.wheel;
      const auto        scale  = text.numbers(2, wheel ? "TH_OFFSET TH_SCALE" : "U_OFFSET U_SCALE");
      const auto        count  = text.numbers(1, "NSLC, the number of slices")[0];
      const auto        parts  = text.numbers(3, "NFEAT NKINK NACCEL");
      const auto        kind   = text.numbers(1, wheel ? "TH_INTPOL" : "U_INTPOL")[0];
      const std::string folder = std::filesystem::path(path).parent_path().string();
      if (!(count >= 4) || count > 10000)
        throw InputError(path + ": NSLC = " + format_number(count) + "; 4 to 10000 slices are accepted");
      if (kind != 1 && kind != 2)
        throw InputError(path + ": " + (wheel ? "TH_INTPOL" : "U_INTPOL") + " = " + format_number(kind) +
                         "; 1 (interpolation) or 2 (smoothing) are accepted");
      slices.smoothed = kind == 2;
      for (int k = 0; k < count; ++k)
        {
          const Line &line     = text.next("slice " + std::to_string(k + 1) + " of " + format_number(count));
          const std::string at = place(path, line.number);
          const auto        name   = quoted(line.text);
          const auto        fields = fields_of(line.text);
          const auto        where  = fields.empty() ? std::nullopt : number_of(fields.front());
          if (!name || !where)
            throw InputError(at + shown(line.text) +
                             ": a place and the name of a file in quotes are expected");
          const double along = (wheel ? 1 : 1e-3) * scale[1] * (scale[0] + *where);
          if (!slices.slices.empty() && !(along > slices.slices.back().along))
            throw InputError(at + "the places of the slices do not ascend; order them along " +
                             (wheel ? "the angle" : "the track"));
          const std::string file = (std::filesystem::path(folder) / *name).string();
          slices.slices.push_back({along, points_of_slice(file, at, unit), {}, file});
        }
      for (const int unused : {1, 2}) // numbers of parts with kinks and accelerations
        if (parts[unused] > 0)
          text.numbers(static_cast<std::size_t>(parts[unused]), "numbers of parts");
      if (parts[0] > 1)
        read_features(text, path, static_cast<std::size_t>(parts[0]), scale, slices);
    }
  } // namespace


  Slices
  read_slices_file(const std::string &path, const ProfileUnit unit)
  {
    Slices slices;
    slices.wheel = lower(std::filesystem::path(path).extension().string()) == ".slcw";
    SlicesText text(path);
    read_slices(text, path, unit, slices);
    return slices;
  }


  std::vector<std::string>
  files_of_slices(const std::string &path)
  {
    std::vector<std::string> files;
    for (const Slices::Slice &slice : read_slices_file(path, ProfileUnit::automatic).slices)
      files.push_back(slice.file);
    return files;
  }
} // namespace wheelrail
