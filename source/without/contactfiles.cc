#include <wheelrail/base/left_out.h>
#include <wheelrail/contactfiles/contact_command.h>
#include <wheelrail/contactfiles/contact_input.h>
#include <wheelrail/contactfiles/wheel_rail_input.h>

#include <string>

namespace wheelrail
{
  std::string
  contact_input(const HalfspaceProblem &, const std::string &)
  {
    refuse_left_out("--contact-input", Subject::contact_files);
  }


  WheelRailInput
  wheel_rail_input(const Scene &, const SceneGeometry &, double, const std::string &, const std::string &)
  {
    refuse_left_out("--contact-wheel-rail-input", Subject::contact_files);
  }


  std::string
  contact_folder(const std::string &)
  {
    refuse_left_out("contact", Subject::contact_files);
  }


  int
  run_contact_command(const ContactFileTask &, std::ostream &)
  {
    refuse_left_out("contact", Subject::contact_files);
  }
} // namespace wheelrail
