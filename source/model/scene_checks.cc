#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/irregularity_checks.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/planned_strip.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_irregularities.h>
#include <wheelrail/verdict/measures.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Sentences = std::vector<std::string>;

    void
    check_rail_length(const Scene &scene, const std::optional<ExpectedPatch> &patch, Sentences &found)
    {
      const double needed = free_rail(scene, patch ? patch->length : 0);
      const double length = scene.mesh_distance() + 2 * (needed + scene.start_offset);
      if (length > scene.rail_length * (1 + 1e-12))
        found.push_back(
          (scene.prepared_distance > 0 ? entry_text(scene, "Mesh", "Prepared distance") : path_text(scene)) +
          ": with " + rounded_mm(needed) + " of free rail at each end" +
          (scene.start_offset > 0 ? " and " + entry_text(scene, "Run", "Start offset") : "") +
          " this needs a rail of " + rounded_mm(length) + ", and Track/Rail length is " +
          rounded_mm(scene.rail_length) + "; " +
          (scene.rail_length > 2 * (needed + scene.start_offset)
             ? "roll at most " + rounded_mm(scene.rail_length - 2 * (needed + scene.start_offset)) +
                 " or lengthen the rail"
             : "lengthen the rail"));
    }

    void
    check_patch(const Scene &scene, const ExpectedPatch &patch, Findings &found)
    {
      const Measures    expected = expected_measures(scene, patch);
      const double      lost     = expected_loss(scene, patch);
      const std::string advised  = rounded_mm(advised_cell(scene.cell_size, lost, scene.wanted_accuracy));
      const std::string size     = "a patch of about " + about(1e3 * patch.width) + " mm x " +
                               about(1e3 * patch.length) + " mm (width x length) is expected";
      if (scene.cell_size > patch.length / 3)
        found.errors.push_back(entry_text(scene, "Mesh", "Solution cell size") + ": too coarse; " + size +
                               " and needs three cells in length, so at most " +
                               rounded_mm(std::floor(1e4 * patch.length / 3) / 1e4) + " is accepted; take " +
                               advised + " for results");
      else if (lost > scene.wanted_accuracy && expected.penalty_part() < expected.mesh_part())
        found.warnings.push_back(entry_text(scene, "Contact", "Penalty scale") +
                                 ": low; the peak pressure will be uncertain by about " +
                                 text("%.0f %%", 100 * lost) + "; raise it for results");
      else if (lost > scene.wanted_accuracy)
        found.warnings.push_back(entry_text(scene, "Mesh", "Solution cell size") + ": coarse; " + size +
                                 text(", some %.1f cells", expected.cells) +
                                 " in one direction, so the peak pressure will be uncertain by about " +
                                 text("%.0f %%; take ", 100 * lost) + advised + " for results");
    }

    std::string
    gigabytes(const double bytes)
    {
      return about(1e-9 * bytes) + " GB";
    }

    void
    check_load(const Scene &scene, Sentences &found)
    {
      if (scene.wheel_load > 0 && scene.wheel_load < expected_unsprung_weight(scene))
        found.push_back(load_too_small(scene, expected_unsprung_weight(scene)));
    }

    /// Cells against what indices and memory hold, ranks against cores.
    void
    check_size(const Scene &scene, const ExpectedPatch &patch, const Machine &machine, Findings &found)
    {
      constexpr double  most_elements = 5e7; // the unknowns of the static start are counted in 32 bits
      const double      elements      = expected_elements(scene, patch);
      const double      memory        = expected_memory(elements, machine.ranks);
      const std::string advice =
        "; take larger cells, a shorter rolling distance or a smaller fine depth or margin";
      const std::string need = entry_text(scene, "Mesh", "Solution cell size") + ": with " +
                               entry_text(scene, "Mesh", "Coarse cell size") + " this makes about " +
                               about_count(elements) + " cells";
      if (elements > most_elements)
        found.errors.push_back(need + ", and " + about_count(most_elements) + " are possible" + advice);
      else if (machine.memory > 0 && memory > 2 * machine.memory)
        found.errors.push_back(need + " and needs some " + gigabytes(memory) +
                               " of memory, this machine has " + gigabytes(machine.memory) + advice);
      else if (machine.free > 0 && memory > machine.free)
        found.warnings.push_back(need + " and may need some " + gigabytes(memory) + " of memory, " +
                                 gigabytes(machine.free) + " are free" + advice);
      if (machine.cores > 0 && machine.ranks > machine.cores)
        found.warnings.push_back(
          "--ranks " + std::to_string(machine.ranks) + ": more than the " + std::to_string(machine.cores) +
          " cores of this machine; ranks that wait for each other take turns, which is "
          "slower than fewer ranks");
    }

    bool
    fits(const Scene &scene, const SceneGeometry &geometry)
    {
      try
        {
          sweep_plan(scene, geometry);
          return true;
        }
      catch (const std::exception &)
        {
          return false;
        }
    }

    /// What would let blocks fit into the sections: smaller ones, or the shift nearest to the wanted one at
    /// which they do, to 0.1 mm.
    std::string
    what_fits(const Scene &scene, const SceneGeometry &geometry)
    {
      for (Scene finer = scene;
           finer.coarse_cell_size > 1.5 * scene.cell_size && finer.coarse_cell_size > 4e-3;)
        {
          finer.coarse_cell_size /= 2;
          if (fits(finer, geometry))
            return " With Mesh/Coarse cell size = " + rounded_mm(finer.coarse_cell_size) + " they can.";
        }
      const auto possible = [&](const double shift) {
        Scene moved         = scene;
        moved.lateral_shift = shift;
        try
          {
            return fits(moved, make_geometry(moved, {geometry.rail, geometry.wheel, {}, geometry.files}));
          }
        catch (const InputError &)
          {
            return false;
          }
      };
      if (scene.lateral_shift == 0 || !possible(0))
        return "";
      double good = 0, bad = scene.lateral_shift;
      while (std::abs(bad - good) > 1e-4)
        {
          const double middle             = 0.5 * (good + bad);
          (possible(middle) ? good : bad) = middle;
        }
      return " With Wheelset/Lateral shift = " + in_mm(std::trunc(1e4 * good) / 1e4) + " they can.";
    }

    /// Whether blocks of the wanted size fit into both sections: lays them out, which takes 20 ms.
    void
    check_sections(const Scene &scene, const SceneGeometry &geometry, Findings &found)
    {
      // with very many blocks that would take long; smaller ones fit better than large ones
      if (scene.coarse_cell_size < 4e-3)
        return;
      try
        {
          sweep_plan(scene, geometry);
        }
      catch (const std::exception &error)
        {
          found.errors.push_back(entry_text(scene, "Mesh", "Coarse cell size") +
                                 ": rail and wheel cannot be divided into cells at " +
                                 entry_text(scene, "Wheelset", "Lateral shift") + ": " + error.what() +
                                 what_fits(scene, geometry));
        }
    }

    /// Whether the planned strip is on the rail head and holds the contact point.
    void
    check_strip(const Scene &scene, const SceneGeometry &geometry, Sentences &errors)
    {
      if (scene.planned_strip.empty())
        return;
      const double x = geometry.contact.rail_x;
      try
        {
          plan_strip(scene, geometry);
          if (x < scene.planned_strip[0] || x > scene.planned_strip[1])
            errors.push_back(entry_text(scene, "Mesh", "Planned strip") +
                             ": the wheel touches the rail beside it, at " + in_mm(x) +
                             "; write none, or a strip around that place and a patch");
        }
      catch (const InputError &error)
        {
          errors.push_back(error.what());
        }
    }

    /// The profiles in touch; nothing, and an error, when they cannot be read or do not touch.
    std::optional<SceneGeometry>
    find_geometry(const Scene &scene, Sentences &errors)
    {
      SceneProfiles profiles;
      try
        {
          profiles = read_mesh_profiles(scene);
        }
      catch (const InputError &error) // it names its entry
        {
          errors.push_back(error.what());
          return {};
        }
      std::optional<SceneGeometry> geometry;
      try
        {
          geometry = smooth_geometry(scene, std::move(profiles));
        }
      catch (const InputError &error)
        {
          errors.push_back(entry_text(scene, "Wheelset", "Lateral shift") + ": " + error.what());
          return {};
        }
      try
        {
          add_irregularities(scene, *geometry);
        }
      catch (const InputError &error) // it names its entry
        {
          errors.push_back(error.what());
          return {};
        }
      return geometry;
    }
  } // namespace


  namespace
  {
    /// The run on larger cells, too, must be possible.
    void
    check_two_meshes(const Scene         &scene,
                     const SceneGeometry &geometry,
                     const Machine       &machine,
                     Sentences           &errors)
    {
      const std::string entry = entry_text(scene, "Run", "Error estimate") + ": ";
      if (!takes_coarser_cells(scene))
        return errors.push_back(entry + "a rail that was rolled over has cells of one size; write model");
      const Scene     coarser = scene_on_coarser_cells(scene);
      const Sentences others  = check_scene(coarser, geometry, machine).errors;
      if (!others.empty())
        errors.push_back(entry + "the second run, on cells of " + rounded_mm(coarser.cell_size) + ": " +
                         others.front());
    }

    /// The checks that need the patch that is expected, where there is one, and the rest.
    void
    check_with(const Scene &scene, const SceneGeometry *geometry, const Machine &machine, Findings &found)
    {
      std::optional<ExpectedPatch> patch;
      if (geometry)
        {
          patch = expected_patch(scene, *geometry);
          check_patch(scene, *patch, found);
          check_size(scene, *patch, machine, found);
          check_irregular_run(scene, *geometry, *patch, found);
        }
      check_load(scene, found.errors);
      check_rail_length(scene, patch, found.errors);
      check_distances(scene, found);
      if (geometry && found.errors.empty())
        check_strip(scene, *geometry, found.errors);
      if (geometry && found.errors.empty())
        check_sections(scene, *geometry, found);
      if (geometry && found.errors.empty() && scene.error_estimate == ErrorEstimate::two_meshes)
        check_two_meshes(scene, *geometry, machine, found.errors);
    }
  } // namespace


  double
  free_rail(const MeshSettings &scene, const double patch_length)
  {
    const double reach = 0.7 * patch_length;
    return std::max(0.1, std::ceil(1e3 * (reach + scene.fine_margin + 3 * scene.coarse_cell_size)) / 1e3);
  }


  CheckedScene
  check_scene(const Scene &scene, const Machine &machine)
  {
    CheckedScene checked{cross_checks(scene), {}};
    // what follows from a wrong track or wheel would only be said twice
    if (checked.found.errors.empty())
      checked.geometry = find_geometry(scene, checked.found.errors);
    check_with(scene, checked.geometry ? &*checked.geometry : nullptr, machine, checked.found);
    return checked;
  }


  Findings
  check_scene(const Scene &scene, const SceneGeometry &geometry, const Machine &machine)
  {
    Findings found = cross_checks(scene);
    check_with(scene, &geometry, machine, found);
    return found;
  }


  SceneGeometry
  require_touching(const SceneInput &input)
  {
    Findings                     found = contact_checks(input.scene);
    std::optional<SceneGeometry> geometry;
    if (found.errors.empty())
      geometry = find_geometry(input.scene, found.errors);
    require_none(found.errors, input);
    return std::move(*geometry);
  }


  SceneGeometry
  require_computable(const SceneInput &input)
  {
    CheckedScene checked = check_scene(input.scene);
    require_none(checked.found.errors, input);
    return std::move(*checked.geometry);
  }
} // namespace wheelrail
