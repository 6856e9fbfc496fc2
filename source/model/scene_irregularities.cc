#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/irregular_shapes.h>
#include <wheelrail/geometry/roughness.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/profiles/height_grid.h>
#include <wheelrail/profiles/roughness_file.h>

#include <cmath>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// What an irregularity is made with.
    struct ShapePlace
    {
      bool          wheel;
      double        radius; ///< of the circle on which the arcs of the wheel count [m]
      IrregularSize size;

      double
      circumference() const
      {
        return wheel ? 2 * M_PI * radius : 0;
      }
    };

    Irregularity
    from_file(const ProfileSettings    &scene,
              const IrregularityData   &data,
              const TouchingProfiles   &profiles,
              const ShapePlace         &at,
              std::vector<std::string> &notes)
    {
      constexpr double least_step = 2e-6;
      if (is_slices_file(data.file))
        return irregularity_of_slices(scene, data, profiles, at.size.place, at.radius, notes);
      const HeightGrid grid = read_height_file(data.file);
      notes.insert(notes.end(), grid.notes.begin(), grid.notes.end());
      Irregularity shape = measured_irregularity(
        grid, at.size.place, std::isfinite(data.lateral) ? data.lateral : 0, at.circumference());
      if (const double end = largest_end(grid); end > least_step && !shape.endless)
        throw InputError(data.file + ": the heights begin or end with a step of " + in_mm(end, 1e6) +
                         "; they must come down to 0 along, within " + in_mm(least_step, 1e6));
      return shape;
    }

    Irregularity
    rough(const IrregularityData &data, const ShapePlace &at, std::vector<std::string> &notes)
    {
      const std::vector<RoughnessBand> bands = read_roughness_file(data.file, notes);
      try
        {
          Irregularity shape = roughness(at.size, bands, data.seed);
          if (at.wheel && shape.end - shape.begin > at.circumference())
            throw InputError("with its ends it is longer than the circumference of the wheel, " +
                             rounded_mm(at.circumference()) + "; take a shorter Length");
          return shape;
        }
      catch (const InputError &error)
        {
          throw InputError(data.file + ": " + error.what());
        }
    }

    Irregularity
    make_shape(const ProfileSettings    &scene,
               const IrregularityData   &data,
               const TouchingProfiles   &profiles,
               const ShapePlace         &at,
               std::vector<std::string> &notes)
    {
      using K = IrregularKind;
      switch (data.kind)
        {
          case K::squat:
            return squat(at.size);
          case K::corrugation:
            return corrugation(at.size, data.wavelength);
          case K::dipped_joint:
            return dipped_joint(at.size);
          case K::flat:
            return fresh_flat(at.size, at.radius);
          case K::weld:
          case K::rounded_flat:
            return rounded_flat(at.size);
          case K::polygon:
            return polygon(at.size, data.order, at.radius);
          case K::roughness:
            return rough(data, at, notes);
          case K::file:
            return from_file(scene, data, profiles, at, notes);
          default:
            return dent(at.size);
        }
    }
  } // namespace


  std::string
  irregularity_name(const int number)
  {
    return "Irregularity " + std::to_string(number + 1);
  }


  PerBody<std::shared_ptr<const Irregularities>>
  make_irregularities(const Scene &scene, const TouchingProfiles &profiles, std::vector<std::string> &notes)
  {
    PerBody<Irregularities> lists;
    const ContactGeometry  &contact = profiles.contact;
    const auto              add     = [&](Irregularity shape, const Body body) {
      if (shape.measures.largest > deepest_offset[body] && !shape.gap)
        shape.carried = CarriedBy::mesh;
      lists[body].push_back(std::move(shape));
    };
    // on the rail places stay where they are when the wheel starts farther along
    const double farther =
      start_in_blocks(scene.start_offset, contact.rolling_radius, scene.cell_size, scene.coarse_cell_size);
    if (scene.rail_by_slices())
      for (Irregularity &shape : rise_of_slices(scene, profiles, farther, notes))
        add(std::move(shape), Body::rail);
    for (int k = 0; k < most_irregularities; ++k)
      {
        const IrregularityData &data = scene.irregularities[k];
        if (data.kind == IrregularKind::none)
          continue;
        const bool       wheel   = data.on_wheel();
        const double     lateral = std::isfinite(data.lateral) ? data.lateral
                                   : wheel                     ? contact.wheel_x
                                                               : contact.rail_x;
        const double     start   = wheel ? 0 : farther;
        const ShapePlace at{
          wheel,
          contact.rolling_radius,
          {data.place - start, lateral, data.length, data.width, data.true_depth(contact.rolling_radius)}};
        try
          {
            std::vector<std::string> found;
            Irregularity             shape = make_shape(scene, data, profiles, at, found);
            for (const std::string &note : found)
              notes.push_back(irregularity_name(k) + "/File: " + note);
            shape.name          = irregularity_name(k);
            const double beside = 30e-3; // the tread around the contact
            shape.measures      = measures_of(shape, lateral - beside, lateral + beside);
            add(std::move(shape), wheel ? Body::wheel : Body::rail);
          }
        catch (const InputError &error)
          {
            throw InputError(irregularity_name(k) + "/" + (data.in_file() ? "File" : "Kind") + ": " +
                             error.what());
          }
      }
    return {std::make_shared<const Irregularities>(std::move(lists.rail)),
            std::make_shared<const Irregularities>(std::move(lists.wheel))};
  }


  void
  add_irregularities(const Scene &scene, SceneGeometry &profiles)
  {
    if (!scene.irregular())
      return;
    const auto made = make_irregularities(scene, profiles, profiles.notes);
    profiles.surfaces.rail.set_irregularities(made.rail);
    profiles.surfaces.wheel.set_irregularities(made.wheel);
  }
} // namespace wheelrail
