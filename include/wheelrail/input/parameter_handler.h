#pragma once

#include <wheelrail/scene/scene.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace wheelrail
{
  /// Declares all entries with default, pattern and meaning. `scene` gets their defaults, and from then on
  /// whatever the handler reads or is told; it must live as long as the handler does that.
  void
  declare_entries(dealii::ParameterHandler &handler, Scene &scene);

  /// Sets one of the declared entries; `section` is empty for those outside all subsections.
  void
  set_entry(dealii::ParameterHandler &handler,
            const std::string        &section,
            const std::string        &name,
            const std::string        &value);
} // namespace wheelrail
