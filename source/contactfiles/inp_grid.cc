#include <wheelrail/contactfiles/inp_groups.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    read_potential_contact(InpWords &words, ContactCase &one)
    {
      const InpGroup kind = words.group("#IPOTCN");
      const int      type = int(kind.values[0]);
      const char    *names;
      switch (type)
        {
          case -1:
            names = "#MX #MY A1 B1 SCALE";
            break;
          case -2:
            names = "#MX #MY A1 AOB SCALE";
            break;
          case -3:
          case -5:
            names = "#MX #MY AA BB SCALE";
            break;
          case -4:
            names = "#MX #MY A1 BB SCALE";
            break;
          case -6:
            names = "#MX #MY AA BNEG BPOS SCALE";
            break;
          case 1:
            names = "#MX #MY XL YL DX DY";
            break;
          case 2:
            names = "#MX #MY XL YL XH YH";
            break;
          case 3:
            names = "#MX #MY XC1 YC1 DX DY";
            break;
          case 4:
            names = "#MX #MY XC1 YC1 XCM YCM";
            break;
          default:
            words.fail(kind.line,
                       "IPOTCN = " + std::to_string(type) +
                         " is unknown; -6 to -1 (Hertzian contact) or 1 to 4 (a grid) is needed");
        }
      const InpGroup group = words.group(names);
      one.grid             = {type, int(group.values[0]), int(group.values[1]), group.from(2), group.line};
      if (const std::string fault = one.grid.fault_of_size(); !fault.empty())
        words.fail(group.line, fault);
      const std::vector<double> &v = one.grid.values;
      // sizes: semi-axes and scale, or elements
      const bool sizes_good = type < 0 ? *std::min_element(v.begin(), v.end()) > 0
                              : type == 2 || (type == 4 && one.grid.mx > 1 && one.grid.my > 1)
                                ? v[2] > v[0] && v[3] > v[1]
                              : type == 4 ? false
                                          : v[2] > 0 && v[3] > 0;
      if (!sizes_good)
        words.fail(group.line,
                   std::string("a size among ") + (names + 8) +
                     " is not positive, or the corners are not in order");
    }

    /// Coefficients (IPLAN = 2), two rectangles from and to in x and y (3), or the number of patches, the
    /// places between them and their factors (4).
    void
    read_planform(InpWords &words, ContactDistance &distance)
    {
      std::vector<double> &plan = distance.plan;
      switch (distance.planform)
        {
          case 1:
            break;
          case 2:
            plan = words.array(6, "the six coefficients of IPLAN = 2").values;
            break;
          case 3:
            plan = words.array(8, "the two rectangles of IPLAN = 3").values;
            break;
          case 4:
            {
              const InpGroup patches = words.group("#NPATCH");
              const double   n       = patches.values[0];
              if (n < 2 || n > 100)
                words.fail(patches.line, "NPATCH, the patches of IPLAN = 4, is not from 2 to 100");
              plan = patches.values;
              for (const double count : {n - 1, n * (n - 1) / 2})
                {
                  const std::vector<double> more =
                    words.array(std::size_t(count), "the places and factors of IPLAN = 4").values;
                  plan.insert(plan.end(), more.begin(), more.end());
                }
              break;
            }
          default:
            words.fail(distance.line,
                       "IPLAN = " + std::to_string(distance.planform) +
                         " is unknown; 1 (all elements), 2 (quadratic), 3 (two rectangles) or 4 (patches) is "
                         "needed");
        }
    }

    void
    read_distance(InpWords &words, ContactCase &one)
    {
      const InpGroup kind = words.group("#IBASE #IPLAN");
      const int      base = int(kind.values[0]), plan = int(kind.values[1]);
      one.distance                = {base, plan, {}, {}, kind.line};
      std::vector<double> &values = one.distance.values;
      switch (base)
        {
          case 1:
            values = words.group("B1 B2 B3 B4 B5 B6").values;
            break;
          case 2:
            {
              const InpGroup group = words.group("#NN XM RM Y1 DY1");
              if (group.values[0] < 2 || group.values[0] > most_contact_elements || group.values[4] <= 0 ||
                  group.values[2] == 0)
                words.fail(
                  group.line,
                  "the profile of IBASE = 2 needs two heights or more, a positive step DY1 and a radius "
                  "RM other than 0");
              values              = group.from(1);
              const InpGroup rest = words.array(std::size_t(group.values[0]), "the heights of IBASE = 2");
              values.insert(values.end(), rest.values.begin(), rest.values.end());
              break;
            }
          case 3:
            {
              const InpGroup group = words.group("B1 B2 B3 B4 B5 B6 B7 B8");
              values               = group.values;
              if (values[6] == 0 || values[7] == 0)
                words.fail(group.line, "B7 or B8 is 0; x and y squared are divided by them");
              break;
            }
          case 9:
            values =
              words.array(std::size_t(one.grid.mx) * one.grid.my, "the undeformed distance of IBASE = 9")
                .values;
            break;
          default:
            words.fail(
              kind.line,
              "IBASE = " + std::to_string(base) +
                " is unknown; 1 (quadratic), 2 (profile and radius), 3 (waves) or 9 (by elements) is "
                "needed");
        }
      read_planform(words, one.distance);
    }
  } // namespace


  void
  read_grid_groups(InpWords &words, ContactCase &one)
  {
    if (one.written.grid == 2)
      read_potential_contact(words, one);
    if (one.written.geometry == 2 && one.grid.kind > 0)
      read_distance(words, one);
    if (one.written.law != 1 && one.digits.variation == 3)
      read_friction(words, one, std::size_t(one.grid.my));
    if (one.written.extra == 9)
      {
        const std::size_t n    = std::size_t(one.grid.mx) * one.grid.my;
        const InpGroup    both = words.array(2 * n, "the extra rigid slip of E = 9");
        one.extra_slip         = {std::vector<double>(n), std::vector<double>(n), both.line};
        for (std::size_t k = 0; k < n; ++k)
          {
            one.extra_slip.x[k] = both.values[2 * k];
            one.extra_slip.y[k] = both.values[2 * k + 1];
          }
      }
  }


  namespace
  {
    std::vector<int>
    integers_of(InpWords &words, const InpGroup &group)
    {
      std::vector<int> integers;
      for (const double value : group.values)
        {
          if (value < 0 || value > most_contact_elements)
            words.fail(group.line, "counts of points below the surface are not from 0 to 1000000");
          integers.push_back(int(value));
        }
      return integers;
    }

    /// A block of points below the surface of the kind that is read already.
    void
    read_point_block(InpWords &words, ContactPoints &block)
    {
      const auto add = [&](const InpGroup &group) {
        const std::vector<int> more = integers_of(words, group);
        block.counts.insert(block.counts.end(), more.begin(), more.end());
        return more;
      };
      const int across = block.kind % 4; // 1, 5: all; 2, 6: from, step, to; 3, 7: lists
      if (block.kind == 9)
        {
          const std::vector<int> n = add(words.group("#NX #NY #NZ"));
          block.x                  = words.array(n[0], "the coordinates x of the points").values;
          block.y                  = words.array(n[1], "the coordinates y of the points").values;
          block.z                  = words.array(n[2], "the coordinates z of the points").values;
          return;
        }
      if (across == 2)
        {
          add(words.group("#IXL #IXINC #IXH"));
          add(words.group("#IYL #IYINC #IYH"));
        }
      if (across == 3)
        for (const int n : add(words.group("#NX #NY")))
          add(words.array(std::size_t(n), "the indices of the points"));
      if (block.kind < 4)
        {
          const InpGroup group = words.group("#NZ ZL DZ");
          add({group.line, {group.values[0]}, ""});
          for (int k = 0; k < int(group.values[0]); ++k)
            block.z.push_back(group.values[1] + k * group.values[2]);
        }
      else
        block.z = words.array(std::size_t(add(words.group("#NZ"))[0]), "the depths of the points").values;
    }
  } // namespace


  void
  read_points(InpWords &words, ContactCase &one)
  {
    if (one.written.subsurface < 2)
      return;
    const InpGroup group = words.group("#A_S #O_S");
    one.points_file      = int(group.values[0]);
    one.points_output    = int(group.values[1]);
    one.points_line      = group.line;
    if (one.written.subsurface == 2)
      return;
    one.points.clear();
    for (;;)
      {
        const InpGroup kind = words.group("#ISUBS");
        ContactPoints  block{int(kind.values[0]), {}, {}, {}, {}, kind.line};
        if (block.kind == 0)
          return;
        if (block.kind < 1 || block.kind > 9 || block.kind == 4 || block.kind == 8)
          words.fail(
            kind.line,
            "ISUBS = " + std::to_string(block.kind) +
              " is unknown; 1, 2, 3, 5, 6, 7, 9 (points below the surface) or 0 (no more) is needed");
        read_point_block(words, block);
        one.points.push_back(std::move(block));
      }
  }
} // namespace wheelrail
