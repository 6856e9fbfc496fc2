#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;

    /// How far the wheel rolls, and when that is enough.
    void
    add_distance(EntryList &list)
    {
      list.number({"Rolling distance", "mm", "> 0 mm", "10 m"},
                  field(&S::rolling_distance),
                  "How far the wheel rolls. until steady: the run ends by itself as soon as all results are "
                  "steady and their standard errors are small enough, at Longest distance at the latest. "
                  "Passages, runs that follow a motion and runs over irregularities, which are never steady, "
                  "then roll the Longest distance.",
                  {{"until steady", 0}});
      list.number({"Longest distance", "mm", "> 0 mm", "10 m"},
                  field(&S::longest_distance),
                  "How far a run until steady rolls at most; mesh and outputs are made for it.");
      list.number({"Standard error", "", "0.0001", "0.1"},
                  field(&S::standard_error),
                  "Standard error that every result may have for a run until steady to end, over a scale of "
                  "its own: of forces friction times load, of the creepage its value at half saturation, of "
                  "the others themselves.");
      list.number(
        {"Wanted accuracy", "", "0.001", "0.5"},
        field(&S::wanted_accuracy),
        "Share within which intervals of 95 % and the model's gap are trusted; twice that: with care.");
      list.choice<ErrorEstimate>(
        "Error estimate",
        {{"model", ErrorEstimate::model}, {"two meshes", ErrorEstimate::two_meshes}},
        field(&S::error_estimate),
        "From what intervals of results follow. model: the true bodies, and what is known of cells; two "
        "meshes: also the same run on cells twice as large, which comes first, beside the folder "
        "(-coarse).");
    }

    /// How many wheels pass over the rail, and when they are enough.
    void
    add_passages(EntryList &list)
    {
      list.count({"Passages", 1, 1000},
                 field(&S::passages),
                 "Wheels that pass one after the other over a rail that yields, each a run in a folder of "
                 "its own (passage_001, ...); passages.csv has their results. until steady: as many as it "
                 "takes until the rail shakes down or each flows as much as the one before.",
                 {{"until steady", 0u}});
      list.name_or_file(
        "Passage list",
        {"none"},
        "a table with commas, or names of .prm files",
        field(&S::passage_list),
        "none: all wheels are as the scene says; else a table of wheels with a row for each, columns load, "
        "lateral shift, traction, velocity or creepage with units in the first line, or scenes over the same "
        "rail, such as heavy.prm, worn.prm; Passages is how often they all pass.");
      list.count({"Most passages", 1, 1000},
                 field(&S::most_passages),
                 "Wheels after which Passages = until steady ends anyway.");
      list.number({"Settled growth", "", "> 0", "0.01"},
                  field(&S::settled_growth),
                  "Growth of the largest plastic strain in a passage (in all of the list) below which the "
                  "rail has shaken down.");
      list.number({"Settled change", "", "> 0", "0.5"},
                  field(&S::settled_change),
                  "Passages are steady when the growth of plastic strain and of forward flow has changed by "
                  "no more than this share, twice in succession.");
    }

    /// The wheel of the passages after the first, and where they start.
    void
    add_wheels(EntryList &list)
    {
      list.choice<NextWheel>(
        "Next wheel",
        {{"fresh", NextWheel::fresh}, {"same", NextWheel::same}},
        field(&S::next_wheel),
        "Of passages after the first. fresh: a new wheel; same: that of the passage before, which comes back "
        "with the same stretch of its tread and keeps what it has yielded.");
      list.count(
        {"Staggered starts", 1, 100},
        field(&S::staggered_starts),
        "Places on the rail, each at least a patch farther along, at which passages start in turn; the first "
        "wheel leaves a pit at the first. auto: two where the path has room for them, else one, and one over "
        "irregularities.",
        {{"auto", 0u}});
    }
  } // namespace


  std::vector<Entry>
  run_entries()
  {
    EntryList list("Run");
    add_distance(list);
    add_passages(list);
    add_wheels(list);
    list.text("Rail",
              field(&S::rail_from),
              "new: a rail without stress; else the folder of a finished run, whose rail is rolled over as "
              "it was left.");
    list.number({"Start offset", "mm", "0 mm", "5 m"},
                field(&S::start_offset),
                "How much farther along the rail the wheel starts than it does otherwise, in whole coarse "
                "cells, the nearest number of them.");
    list.number({"Averaging distance", "mm", "> 0 mm", "10 m"},
                field(&S::averaging_distance),
                "The results of the summary are means over a stretch of this length; of a run that ends when "
                "it is steady, over the stretch that it has found.");
    list.number({"Evaluate at", "mm", "> 0 mm", "10 m"},
                field(&S::evaluate_at),
                "Middle of that stretch, as rolled distance; end: the last one; largest force: around the "
                "largest vertical force over irregular surfaces. A place needs a given Rolling distance.",
                {{"end", 0}, {"largest force", S::at_largest_force}});
    list.choice<StartState>(
      "Start",
      {{"steady rolling", StartState::steady_rolling},
       {"without creepage", StartState::without_creepage},
       {"without tractions", StartState::without_tractions},
       {"without velocities", StartState::without_velocities},
       {"normal load", StartState::normal_load}},
      field(&S::start),
      "What the run begins with. steady rolling: static equilibrium with the creepage and the tractions of "
      "half-spaces, and the velocities of fields that travel with the contact; the others leave out one of "
      "the three, or (normal load) all, and settle later.");
    list.number({"Time step factor", "", "0.001", "0.98"},
                field(&S::time_step_factor),
                "Time step as a fraction of the stable one.");
    list.number({"Bulk viscosity", "", "0", "1"},
                field(&S::bulk_viscosity),
                "Linear bulk viscosity coefficient; damps shocks.");
    list.number({"Energy limit", "", "> 0", "1"},
                field(&S::energy_limit),
                "Energy error, relative to strain plus dissipated energy, at which the run stops.");
    return list.entries;
  }
} // namespace wheelrail
