#pragma once

#include <iosfwd>
#include <string>

namespace wheelrail
{
  /// What is asked of an input file of CONTACT.
  struct ContactFileTask
  {
    std::string file;
    int         only    = 0;     ///< the case of that place in the file, counted from 1; 0: all
    bool        printed = false; ///< CONTACT's own result blocks, too
    bool        bodies  = false; ///< cases of module 1 between true bodies, too
  };

  /// The folder of its results: output/NAME-contact.
  std::string
  contact_folder(const std::string &file);

  /// Reads the file, solves its cases, prints a row of each and what is refused, and writes into
  /// output/NAME-contact: case_table() of module 3 (cases.csv and .h5), wheel_rail_table() and patch_table()
  /// of module 1 (wheel_rail and patches), point_table() (points), the fields of each case K, a tick a patch
  /// (case_K.h5), summary.json, with `bodies` bodies_table() (bodies), and with `printed` printed_blocks()
  /// (NAME.out). Returns 0, or 2 when a case was refused, by true bodies too, or not solved as it should.
  /// Throws InputError for a faulty file, a case that is not there, and where all are refused; Interrupted
  /// once a signal has come: cases that were solved before it are kept.
  int
  run_contact_command(const ContactFileTask &task, std::ostream &out);
} // namespace wheelrail
