#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;
  } // namespace


  std::vector<Entry>
  output_entries()
  {
    std::vector<Entry> list;
    list.push_back(
      text_entry({"Output",
                  "Folder",
                  "Folder of the results, made by the program; a relative one counts from where the "
                  "command is given."},
                 field(&S::folder)));
    list.push_back(
      count_entry({"Output", "Ticks", "Evenly spaced outputs of patch and surface fields over the run."},
                  1,
                  10000,
                  field(&S::ticks)));
    list.push_back(choice_entry<bool>({"Output", "Volume fields", "Write the whole mesh at start and end."},
                                      {{"true", true}, {"false", false}},
                                      field(&S::volume_fields)));
    const auto interval = field(&S::checkpoint_interval);
    list.push_back(
      with_word(number_entry({"Output",
                              "Checkpoint interval",
                              "Wall time between two saved states, for --resume; auto: one minute, or a "
                              "hundred times what saving takes when that is longer."},
                             Dimension::time,
                             "s",
                             Bounds::above("0 s", "86400 s"),
                             interval),
                "auto",
                0,
                interval));
    return list;
  }
} // namespace wheelrail
