#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    keep_within(FileContent &content, const HeaderValues &values, const std::string &axis)
    {
      const double low  = values.number("bound." + axis + ".min", 1),
                   high = values.number("bound." + axis + ".max", 0);
      if (low > high) // in this format: no bounds
        return;
      const std::size_t before = content.points.size();
      content.points.erase(std::remove_if(content.points.begin(),
                                          content.points.end(),
                                          [&](const FilePoint &p) {
                                            const double v = axis == "y" ? p.position.x : p.position.y;
                                            return v < low || v > high;
                                          }),
                           content.points.end());
      if (content.points.size() < before)
        content.notes.push_back(counted(before - content.points.size(), "point") + " outside bound." + axis +
                                ".min and .max of the file dropped");
    }

    /// What the header orders, in the order of the format: least distance, shift, rotation, bounds,
    /// mirroring, inversion.
    void
    apply_orders(FileContent &content, const HeaderValues &values)
    {
      std::vector<FilePoint> &points = content.points;
      const double            least  = values.number("point.dist.min", 0);
      if (least > 0)
        {
          std::vector<FilePoint> kept;
          for (const FilePoint &p : points)
            if (kept.empty() || norm(p.position - kept.back().position) >= least)
              kept.push_back(p);
          if (kept.size() < points.size())
            content.notes.push_back(counted(points.size() - kept.size(), "point") +
                                    " nearer than point.dist.min of the file dropped");
          points = kept;
        }
      const Point2 shift{values.number("shift.y", 0), values.number("shift.z", 0)};
      const double angle =
        values.number("rotate", 0) / std::max(1e-300, std::abs(values.number("units.ang.f", 1)));
      const double c = std::cos(angle), s = std::sin(angle);
      for (FilePoint &p : points)
        {
          const Point2 q = p.position + shift;
          p.position     = {c * q.x - s * q.y, s * q.x + c * q.y};
        }
      if (shift.x != 0 || shift.y != 0)
        content.notes.push_back("moved by shift.y = " + format_number(shift.x) +
                                " and shift.z = " + format_number(shift.y) + " of the file");
      if (angle != 0)
        content.notes.push_back("turned by rotate = " + format_number(values.number("rotate", 0)) +
                                " of the file");
      keep_within(content, values, "y");
      keep_within(content, values, "z");
      const bool mirror_y = values.number("mirror.y", 0) == 1, mirror_z = values.number("mirror.z", 0) == 1;
      for (FilePoint &p : points)
        p.position = {mirror_y ? -p.position.x : p.position.x, mirror_z ? -p.position.y : p.position.y};
      if (mirror_y || mirror_z)
        content.notes.push_back(std::string("mirrored by ") + (mirror_y ? "mirror.y" : "") +
                                (mirror_y && mirror_z ? " and " : "") + (mirror_z ? "mirror.z" : "") +
                                " of the file");
      if (values.number("inversion", 0) == 1)
        {
          std::reverse(points.begin(), points.end());
          content.notes.push_back("order of the points reversed by inversion of the file");
        }
    }

    /// What the weights in the third column of the point block say.
    struct Weights
    {
      std::size_t zero = 0, other = 0; ///< points of weight 0, and of another one than 0 and 1
    };

    /// A line of the point block; weight 0 drops the point, all other weights count as 1.
    void
    read_simpack_point(FileContent       &content,
                       const Line        &line,
                       const std::string &file,
                       Weights           &weights,
                       LeftOut           &left_out)
    {
      if (is_switched_off(line, left_out))
        return;
      const std::vector<double> numbers = numbers_of(line, 2, file, left_out);
      const double              weight  = numbers.size() > 2 ? numbers[2] : 1;
      if (weight == 0)
        {
          ++weights.zero;
          ++content.listed;
          return;
        }
      weights.other += weight != 1;
      add_point(content, {numbers[0], numbers[1]}, line.number, file);
    }

    void
    note_weights(FileContent &content, const Weights &weights)
    {
      if (weights.zero > 0)
        content.notes.push_back(counted(weights.zero, "point") + " of weight 0 dropped");
      if (weights.other > 0)
        content.notes.push_back(counted(weights.other, "weight") + " other than 0 and 1 taken as 1");
    }

    /// The kind of profile that the header states. A "type" in the block of the spline is another thing: the
    /// kind of the file from which the spline was made.
    void
    read_kind(FileContent &content, const HeaderValues &values, const HeaderValues &spline)
    {
      if (values.has("type") && spline.has("type") &&
          values.texts.at("type").text != spline.texts.at("type").text)
        content.notes.push_back("type = " + spline.texts.at("type").text + " in line " +
                                std::to_string(spline.texts.at("type").number) +
                                " left out: in the spline block it is the kind of the original data");
      if (!values.has("type"))
        return;
      const Line  &line  = values.texts.at("type");
      const double value = values.number("type", 0);
      if (value != 0 && value != 1)
        throw InputError(place(values.file, line.number) + "type = " + shown(line.text) +
                         ": 0 (rail) or 1 (wheel) is accepted");
      content.kind_stated = true;
      content.kind        = value == 1 ? ProfileKind::wheel : ProfileKind::rail;
      content.kind_line   = line.number;
    }

    void
    read_unit(FileContent &content, const HeaderValues &values)
    {
      if (!values.has("units.len.f"))
        return;
      const Line  &line   = values.texts.at("units.len.f");
      const double factor = values.number("units.len.f", 0);
      if (!(factor >= 1e-6 && factor <= 1e9))
        throw InputError(place(values.file, line.number) + "units.len.f = " + shown(line.text) +
                         ": file units per metre are needed, 1000 for mm");
      content.metres_per_unit = 1 / factor;
    }
  } // namespace


  FileContent
  parse_simpack(const std::vector<Line> &lines, const std::string &file)
  {
    FileContent  content;
    HeaderValues values{file, {}}, spline{file, {}};
    unsigned int begin = 0;
    Weights      weights;
    LeftOut      left_out;
    bool         in_spline = false, inside = false, ended = false;
    content.format = "SIMPACK";
    content.down   = true;
    for (const Line &whole : lines)
      {
        const Line        line{without_comment(whole.text, "!"), whole.number};
        const std::string word = lower(line.text);
        if (word.empty() || ended)
          continue;
        if (word == "point.begin")
          {
            if (begin > 0)
              throw InputError(place(file, line.number) + "a second point.begin, the first is in line " +
                               std::to_string(begin) + "; one profile per file is read: split the file");
            begin  = line.number;
            inside = true;
          }
        else if (word == "point.end")
          {
            inside = false;
            ended  = begin > 0;
          }
        else if (inside)
          read_simpack_point(content, line, file, weights, left_out);
        else if (word == "spline.begin" || word == "spline.end")
          in_spline = word == "spline.begin";
        else
          (in_spline ? spline : values).take(line);
      }
    if (begin == 0)
      throw InputError(file +
                       ": a SIMPACK profile without \"point.begin\"; its points are between "
                       "point.begin and point.end");
    if (inside)
      throw InputError(place(file, begin) + "point.begin without \"point.end\"; the file may be cut off");
    left_out.tell(content.notes);
    note_weights(content, weights);
    read_kind(content, values, spline);
    values.texts.merge(spline.texts);
    content.rounding = rounding_of(positions(content.points)); // orders may turn it
    apply_orders(content, values);
    read_unit(content, values);
    return content;
  }
} // namespace wheelrail
