// label: long
// Half-spaces of a wheelset with yaw against all rows of CONTACT's table.

#include "halfspace_yaw.h"


BOOST_AUTO_TEST_CASE(halfspace_yaw_long)
{
  for (const auto &row : test::read_table("contact_wheel_rail_54E1_yaw.csv"))
    test::check_yaw_row(row);
}
