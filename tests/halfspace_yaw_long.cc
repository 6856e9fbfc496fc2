// label: long
// Half-spaces of a wheelset with yaw against all rows of CONTACT's table.

#include "halfspace_yaw.h"

int
main()
{
  for (const auto &row : test::read_table("contact_wheel_rail_54E1_yaw.csv"))
    test::check_yaw_row(row);
  return test::report();
}
