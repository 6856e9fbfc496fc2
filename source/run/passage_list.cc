#include <wheelrail/reference/motion_file.h>
#include <wheelrail/run/passage_list.h>

#include <algorithm>
#include <cstddef>

namespace wheelrail
{
  std::vector<Scene>
  passage_scenes(const Scene &scene)
  {
    if (scene.passage_list == "none")
      return {scene};
    const MotionFile   rows = read_passage_list(scene.passage_list);
    std::vector<Scene> round;
    double             planned = scene.planned_load;
    for (std::size_t row = 0; row < rows.rows(); ++row)
      {
        round.push_back(scene_at(scene, rows, row));
        if (rows.find(MotionQuantity::load))
          planned = std::max(planned, round.back().wheel_load);
      }
    for (Scene &one : round)
      one.planned_load = planned;
    return round;
  }
} // namespace wheelrail
