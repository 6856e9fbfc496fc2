"""Every file includes the standard headers of the names that it uses, itself or by the header of the same name, so
that a header that drops an include breaks no other file.

Usage: includes.py SOURCE_FOLDER
"""

import glob
import os
import re
import sys

from checks import check, finish

ROOT = sys.argv[1]

# names of namespace std, and functions of C
NAMES = {
    "algorithm": "sort stable_sort clamp min max min_element max_element find find_if any_of all_of none_of copy fill "
                 "reverse replace lower_bound upper_bound unique rotate count count_if transform binary_search "
                 "remove_if nth_element is_sorted",
    "array": "array",
    "atomic": "atomic",
    "chrono": "chrono::steady_clock chrono::duration",
    "cmath": "sqrt pow abs fabs sin cos tan asin acos atan atan2 exp log log2 log10 cbrt hypot floor ceil round lround "
             "llround isnan isfinite isinf remainder fmod nan",
    "complex": "complex",
    "csignal": "sig_atomic_t signal",
    "cstdint": "uint8_t uint32_t uint64_t int32_t int64_t",
    "cstdio": "snprintf printf fopen fclose fwrite fread remove rename",
    "cstdlib": "getenv strtoul strtol strtod system exit atoi",
    "cstring": "memcpy memset strlen strcmp strerror",
    "filesystem": "filesystem::path filesystem::exists filesystem::is_directory filesystem::create_directories",
    "fstream": "ifstream ofstream",
    "functional": "function",
    "iomanip": "setprecision setw setfill",
    "iostream": "cout cerr",
    "iterator": "istreambuf_iterator back_inserter",
    "limits": "numeric_limits",
    "map": "map",
    "memory": "unique_ptr make_unique shared_ptr make_shared",
    "new": "bad_alloc align_val_t",
    "numeric": "accumulate iota inner_product",
    "optional": "optional nullopt",
    "queue": "queue priority_queue",
    "random": "mt19937 uniform_real_distribution normal_distribution uniform_int_distribution",
    "regex": "regex smatch sregex_iterator",
    "set": "set",
    "sstream": "ostringstream istringstream stringstream",
    "stdexcept": "runtime_error logic_error invalid_argument out_of_range",
    "string": "string to_string getline stod stoi",
    "thread": "this_thread::sleep_for",
    "tuple": "tuple tie make_tuple",
    "unordered_map": "unordered_map",
    "utility": "pair move swap exchange",
    "variant": "variant",
    "vector": "vector",
}
# a header that has to bring the names of another one along
BRINGS = {"sstream": ["string"], "fstream": ["string"], "iostream": ["ostream"], "map": ["utility"], "string": [],
          "algorithm": ["utility"], "vector": ["utility"], "array": ["utility"], "memory": ["utility"],
          "functional": ["utility"], "optional": ["utility"], "regex": ["string"], "filesystem": ["string"]}


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def includes(text):
    found = set(re.findall(r"#include <(\w+)>", text))
    return found | {other for header in found for other in BRINGS.get(header, [])}


def without_texts(text):
    """The code without comments and literals."""
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', " ", text, flags=re.S)


def missing(path):
    text = text_of(path)
    known = includes(text)
    for own in re.findall(r"#include <(wheelrail/[\w/]+\.h)>", text):
        if os.path.basename(own)[:-2] == os.path.basename(path).rsplit(".", 1)[0]:
            known |= includes(text_of(os.path.join(ROOT, "include", own)))
    code = without_texts(text)
    used = set(re.findall(r"\bstd::((?:chrono::|filesystem::|this_thread::)?\w+)", code))
    return sorted(header for header, names in NAMES.items() if header not in known and used & set(names.split()))


def main():
    files = [path for folder in ("include", "source", "tests", "benchmarks")
             for path in sorted(glob.glob(f"{ROOT}/{folder}/**/*", recursive=True)) if path.endswith((".h", ".cc"))]
    for path in files:
        for header in missing(path):
            check(False, f"{os.path.relpath(path, ROOT)} uses names of <{header}> without including it")
    check(len(files) > 200, f"{len(files)} files looked through")
    finish()


main()
