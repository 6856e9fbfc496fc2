#pragma once

#include <wheelrail/input/flat_input.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace wheelrail
{
  /// Stands in a subsection of a handler, if it has a name, and leaves it also when a value is refused.
  class InSection
  {
  public:
    InSection(dealii::ParameterHandler &handler, const std::string &section);
    ~InSection();

    InSection(const InSection &) = delete;
    InSection &
    operator=(const InSection &) = delete;

  private:
    dealii::ParameterHandler &handler_;
    bool                      entered_;
  };

  /// Declares all entries with default, pattern and meaning. `scene` gets their defaults, and from then on
  /// whatever the handler reads or gets; it must live as long as the handler does that.
  void
  declare_entries(dealii::ParameterHandler &handler, Scene &scene);

  /// Sets one of the declared entries; `section` is empty for those outside all subsections.
  void
  set_entry(dealii::ParameterHandler &handler,
            const std::string        &section,
            const std::string        &name,
            const std::string        &value);

  /// A scene from the text of a parameter file without includes. `assignments` are all that are in force,
  /// those of --set included: what deal.II reads otherwise (a brace, and what is not in the text) is set
  /// after it. All of it must have been checked.
  void
  parse_entries(const std::string &text, const std::vector<Assignment> &assignments, Scene &scene);
} // namespace wheelrail
