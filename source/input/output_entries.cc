#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <vector>

namespace wheelrail
{
  std::vector<Entry>
  output_entries()
  {
    EntryList list("Output");
    list.text("Folder",
              field(&Scene::folder),
              "Folder of the results, made by the program; a relative one counts from where the command is "
              "given. Where the scene itself names none: output/ and the name of its file.");
    list.count({"Ticks", 1, 10000},
               field(&Scene::ticks),
               "Evenly spaced outputs of patch and surface fields over the run.");
    list.choice<bool>("Volume fields",
                      {{"true", true}, {"false", false}},
                      field(&Scene::volume_fields),
                      "Write the whole mesh at start and end.");
    list.number({"Checkpoint interval", "s", "> 0 s", "86400 s"},
                field(&Scene::checkpoint_interval),
                "Wall time between two saved states, for --resume; auto: one minute, or a hundred times what "
                "saving takes when that is longer.",
                {{"auto", 0}});
    return list.entries;
  }
} // namespace wheelrail
