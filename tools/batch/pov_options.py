# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""POV-Ray's options of a batch: refuses those that the batch sets, makes file names absolute."""

import os
import re

from tools.batch.key import Links
from tools.batch.store import BatchError

REFUSED_SWITCHES = {
    "I": "give the scene as the first argument",
    "O": "use --output",
    "C": "the batch continues by itself: run the same command again",
    "SR": "a batch renders whole pictures",
    "ER": "a batch renders whole pictures",
    "SC": "a batch renders whole pictures",
    "EC": "a batch renders whole pictures",
    "SF": "use batch film --frames",
    "EF": "use batch film --frames",
    "KFI": "use batch film --frames",
    "KFF": "use batch film --frames",
    "HI": "include the file in the scene",
    "RF": "saved passes of radiosity are not supported",
    "UF": "fields are not supported",
    "TH": "a dithered pixel depends on the rows above it, which bands do not have",
}
REFUSED_NAMES = {
    "input_file_name": "I",
    "output_file_name": "O",
    "continue_trace": "C",
    "start_row": "SR",
    "end_row": "ER",
    "start_column": "SC",
    "end_column": "EC",
    "subset_start_frame": "SF",
    "subset_end_frame": "EF",
    "initial_frame": "KFI",
    "final_frame": "KFF",
    "field_render": "UF",
    "dither": "TH",
    "include_header": "HI",
    "radiosity_file_name": "RF",
    "radiosity_from_file": "RF",
    "radiosity_to_file": "RF",
}
FORMATS = {"N": "png", "E": "exr"}


def unquoted(text):
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        return text[1:-1]
    return text


class PovOptions:
    """Keeps the order, because later options override earlier ones."""

    def __init__(self, words):
        self.words, self.libraries, self.inis = [], [], []
        self.kind, self.threads = None, None
        for word in words:
            self.add(word)

    def add(self, word):
        named = re.fullmatch(r"([A-Za-z_]+)\s*=(.*)", word, re.DOTALL)
        if word == "--unrestricted":
            self.words.append(word)
        elif word[:1] in "+-" and len(word) > 1:
            self.add_switch(word)
        elif named:
            self.add_named(word, named.group(1).lower(), named.group(2).strip())
        elif re.search(r"\.ini(\[[^\]]*\])?$", word, re.IGNORECASE):
            section = re.search(r"(\[[^\]]*\])?$", word).group(0)
            self.words.append(f"{Links.UP}options{len(self.inis)}.ini{section}")
            self.inis.append(word)
        else:
            raise BatchError(
                f"{word!r} is neither an option of batch nor one of POV-Ray (+W640, Width=640, NAME.ini). "
                "A batch renders one scene, the first argument."
            )

    def add_switch(self, word):
        body = word[1:]
        upper = body.upper()
        for switch, instead in REFUSED_SWITCHES.items():
            exact = switch in ("C", "UF") and upper == switch
            with_value = switch not in ("C", "UF") and re.fullmatch(re.escape(switch) + r".*", upper, re.DOTALL)
            if exact or (with_value and not (word[0] == "-" and switch == "TH")):
                raise BatchError(f"a batch sets {word!r} itself: {instead}.")
        if upper.startswith("F"):
            self.set_kind(word, body[1:])
        elif upper.startswith("WT"):
            self.set_threads(word, body[2:])
        elif upper.startswith("L"):
            self.libraries.append(unquoted(body[1:]))
        else:
            self.words.append(word)

    def add_named(self, word, name, value):
        if name in REFUSED_NAMES and not (name == "dither" and value.lower() in ("off", "false", "no", "0")):
            raise BatchError(f"a batch sets {word!r} itself: {REFUSED_SWITCHES[REFUSED_NAMES[name]]}.")
        if name.endswith("_command"):
            raise BatchError(f"{word!r} would run once for each band; run the command after the batch instead.")
        if name == "output_file_type":
            self.set_kind(word, value)
        elif name == "work_threads":
            self.set_threads(word, value)
        elif name == "library_path":
            self.libraries.append(unquoted(value))
        else:
            self.words.append(word)

    def set_kind(self, word, value):
        if value[:1].upper() not in FORMATS:
            raise BatchError(
                f"{word!r}: a batch writes PNG (+FN, +FN16) or OpenEXR (+FE), whose parts can be put " "together without a change."
            )
        self.kind = FORMATS[value[:1].upper()]
        self.words.append(f"+F{value.upper()}")

    def set_threads(self, word, value):
        if not value.isdigit() or int(value) < 1:
            raise BatchError(f"{word!r}: expected a number of threads, as in +WT1.")
        self.threads = int(value)

    def named_files(self, folder):
        for library in self.libraries:
            yield os.path.join(folder, library)
        for ini in self.inis:
            yield os.path.join(folder, re.sub(r"\[[^\]]*\]$", "", ini))
