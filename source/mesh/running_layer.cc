#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/running_layer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace wheelrail
{
  namespace
  {
    // Outward normal of the contact in the frame of the builder: the wheel stands upside down there.
    Point2
    frame_normal(const RunningLayerInput &input)
    {
      const Point2 n = input.strip.frame.normal();
      const Point2 d = input.placement.to_section(input.strip.frame.origin + n) -
                       input.placement.to_section(input.strip.frame.origin);
      return input.curve.y_factor * Point2{-d.x, input.curve.y_factor * d.y};
    }

    // Curve parameters of the strip's block boundaries.
    std::vector<double>
    strip_parameters(const FrameProfile &profile, const RunningLayerInput &input)
    {
      const std::vector<double> &s = input.strip.s;
      if (s.size() < 2 || !std::is_sorted(s.begin(), s.end()))
        throw InputError("The fine strip needs two or more ascending block boundaries.");
      if (s.front() < profile.s_min() || s.back() > profile.s_max())
        throw InputError("The fine strip from " + in_mm(s.front()) + " to " + in_mm(s.back()) +
                         " reaches beyond the part of the profile from " + in_mm(profile.s_min()) + " to " +
                         in_mm(profile.s_max()) +
                         " that can be seen from the contact point. Use a narrower strip.");
      std::vector<double> t;
      for (const double value : s)
        t.push_back(profile.parameter(value));
      return t;
    }

    double
    signed_length(const Curve &curve, const double t0, const double t1)
    {
      return t0 <= t1 ? curve.length(t0, t1) : -curve.length(t1, t0);
    }

    // Parameter of an end of the layer next to an end of the strip; `sign` is -1 at the start.
    double
    place_end(const RunningLayerInput &input, const LayerEnd &end, const double strip, const double sign)
    {
      const Curve &curve = *input.curve.curve;
      const double rest  = sign * signed_length(curve, strip, end.parameter);
      if (end.movable)
        return rest < input.block_size ? curve.advance(strip, sign * input.block_size) : end.parameter;
      // thinner rests would be cells that cut the stable time step
      if (rest < 0.05 * input.block_size)
        throw InputError("The fine strip ends " + in_mm(std::abs(rest)) + (rest < 0 ? " beyond" : " before") +
                         " the end of the running surface; " + in_mm(0.05 * input.block_size) +
                         " are needed between them. Use a narrower strip or another lateral shift.");
      return end.parameter;
    }

    // Block counts of the rests on both sides of the strip, which place_end() leaves room for.
    std::array<unsigned int, 2>
    rest_counts(const std::array<double, 2> &rest, const unsigned int strip, const RunningLayerInput &input)
    {
      std::array<unsigned int, 2> n{
        {block_count(rest[0], input.block_size), block_count(rest[1], input.block_size)}};
      while (n[0] + n[1] + strip < input.minimum_count)
        ++n[rest[0] / n[0] > rest[1] / n[1] ? 0 : 1];
      return n;
    }

    // Corners below those of the layer; `first` to `last` belong to the strip. Parallel block sides there
    // make cells that are as wide below as on the surface, and equal on both bodies.
    std::vector<Point2>
    inner_points(const SectionBuilder      &builder,
                 const Side                &outer,
                 const std::vector<Point2> &normals,
                 const unsigned int         first,
                 const unsigned int         last,
                 const RunningLayerInput   &input)
    {
      const Point2        n = frame_normal(input);
      std::vector<Point2> inner;
      for (unsigned int i = 0; i < outer.size(); ++i)
        inner.push_back(builder.point(outer[i]) - input.depth * (i >= first && i <= last ? n : normals[i]));
      return inner;
    }
  } // namespace


  unsigned int
  block_count(const double length, const double block_size)
  {
    return std::max(1L, std::lround(length / block_size));
  }


  RunningLayer
  make_running_layer(SectionBuilder &builder, const RunningLayerInput &input)
  {
    const Curve &curve   = *input.curve.curve;
    const auto   profile = std::make_shared<const FrameProfile>(curve, input.placement, input.strip.frame);

    const std::vector<double> &s      = input.strip.s;
    const std::vector<double>  t      = strip_parameters(*profile, input);
    const unsigned int         blocks = t.size() - 1;
    RunningLayer               layer;
    layer.start = place_end(input, input.start, t.front(), -1);
    layer.end   = place_end(input, input.end, t.back(), 1);
    const std::array<double, 2> rest{
      {curve.length(layer.start, t.front()), curve.length(t.back(), layer.end)}};
    const std::array<unsigned int, 2> n = rest_counts(rest, blocks, input);

    Side strip;
    for (const double parameter : t)
      strip.push_back(builder.corner(input.curve.position(parameter)));
    for (unsigned int i = 0; i < blocks; ++i)
      builder.curve(
        strip[i], strip[i + 1], [profile, mirrored = input.curve, s0 = s[i], s1 = s[i + 1]](const double u) {
          return mirrored.position(profile->parameter((1 - u) * s0 + u * s1));
        });

    layer.outer                    = strip;
    std::vector<double> parameters = t;
    if (n[0] > 0)
      {
        const CurveStretch stretch(input.curve, layer.start, t.front());
        layer.outer = joined(builder.along(builder.corner(stretch(0)), strip.front(), stretch, n[0]), strip);
        for (unsigned int i = n[0]; i-- > 0;)
          parameters.insert(parameters.begin(), stretch.parameter(double(i) / n[0]));
      }
    if (n[1] > 0)
      {
        const CurveStretch stretch(input.curve, t.back(), layer.end);
        layer.outer =
          joined(layer.outer, builder.along(strip.back(), builder.corner(stretch(1)), stretch, n[1]));
        for (unsigned int i = 1; i <= n[1]; ++i)
          parameters.push_back(stretch.parameter(double(i) / n[1]));
      }
    builder.mark(layer.outer, Boundary::running);

    std::vector<Point2> normals;
    for (const double parameter : parameters)
      normals.push_back(input.curve.normal(parameter));
    layer.strip_begin = n[0];
    layer.strip_end   = n[0] + blocks;
    layer.inner = inner_points(builder, layer.outer, normals, layer.strip_begin, layer.strip_end, input);
    if (n[0] > 0)
      layer.inner.front() = input.start.inner(layer.start);
    if (n[1] > 0)
      layer.inner.back() = input.end.inner(layer.end);
    return layer;
  }
} // namespace wheelrail
