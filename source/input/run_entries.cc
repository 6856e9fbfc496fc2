#include <wheelrail/input/halfspace_entries.h>
#include <wheelrail/input/run_entries.h>
#include <wheelrail/input/special_entries.h>

namespace wheelrail
{
  namespace
  {
    using D = Dimension;
    using B = Bounds;
    using S = Scene;

    void
    add_mesh(std::vector<Entry> &list)
    {
      list.push_back(
        length_entry({"Mesh", "Solution cell size", "1 mm", "Edge of the cells in and around the patch."},
                     "mm",
                     B::between("0.1 mm", "16 mm"),
                     field(&S::cell_size)));
      list.push_back(length_entry({"Mesh",
                                   "Coarse cell size",
                                   "16 mm",
                                   "Edge of the cells far from the patch; 2, 4, 8, ... solution cells."},
                                  "mm",
                                  B::between("0.2 mm", "64 mm"),
                                  field(&S::coarse_cell_size)));
      list.push_back(fine_depth_entry());
      list.push_back(length_entry(
        {"Mesh", "Fine margin", "3 mm", "Solution cells reach this far beyond the expected patch."},
        "mm",
        B::between("0.1 mm", "50 mm"),
        field(&S::fine_margin)));
      list.push_back(prepared_distance_entry());
      for (const Entry &entry : element_entries())
        list.push_back(entry);
    }

    void
    add_run(std::vector<Entry> &list)
    {
      list.push_back(length_entry({"Run", "Rolling distance", "60 mm", "How far the wheel rolls."},
                                  "mm",
                                  B::above("0 mm", "10 m"),
                                  field(&S::rolling_distance)));
      list.push_back(length_entry({"Run",
                                   "Averaging distance",
                                   "20 mm",
                                   "The figures of the summary are means over this last stretch of the run."},
                                  "mm",
                                  B::above("0 mm", "10 m"),
                                  field(&S::averaging_distance)));
      list.push_back(
        choice_entry<StartState>({"Run",
                                  "Start",
                                  "steady rolling",
                                  "What the run begins with. steady rolling: static equilibrium with the "
                                  "creepage and the tractions of "
                                  "half-spaces, and the velocities of fields that travel with the contact; "
                                  "the others leave out one of "
                                  "the three, or (normal load) all, and roll longer until they are steady."},
                                 {{"steady rolling", StartState::steady_rolling},
                                  {"without creepage", StartState::without_creepage},
                                  {"without tractions", StartState::without_tractions},
                                  {"without velocities", StartState::without_velocities},
                                  {"normal load", StartState::normal_load}},
                                 field(&S::start)));
      list.push_back(
        pure_entry({"Run", "Time step factor", "0.95", "Time step as a fraction of the stable one."},
                   B::above("0", "1"),
                   field(&S::time_step_factor)));
      list.push_back(
        pure_entry({"Run", "Bulk viscosity", "0.06", "Linear bulk viscosity coefficient; damps shocks."},
                   B::between("0", "1"),
                   field(&S::bulk_viscosity)));
      list.push_back(
        pure_entry({"Run",
                    "Energy limit",
                    "0.05",
                    "Energy error, relative to strain plus dissipated energy, at which the run stops."},
                   B::above("0", "1"),
                   field(&S::energy_limit)));
    }

    void
    add_output(std::vector<Entry> &list)
    {
      list.push_back(
        text_entry({"Output",
                    "Folder",
                    "output/scene",
                    "Folder of the results, made by the program; a relative one counts from where the "
                    "command is given."},
                   field(&S::folder)));
      list.push_back(count_entry(
        {"Output", "Ticks", "20", "Evenly spaced outputs of patch and surface fields over the run."},
        1,
        10000,
        field(&S::ticks)));
      list.push_back(
        choice_entry<bool>({"Output", "Volume fields", "true", "Write the whole mesh at start and end."},
                           {{"true", true}, {"false", false}},
                           field(&S::volume_fields)));
      list.push_back(checkpoint_interval_entry());
    }
  } // namespace


  std::vector<Entry>
  run_entries()
  {
    std::vector<Entry> list;
    add_mesh(list);
    add_run(list);
    add_output(list);
    for (const Entry &entry : halfspace_entries())
      list.push_back(entry);
    return list;
  }
} // namespace wheelrail
