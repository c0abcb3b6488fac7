# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page reader misses no example and no broken link."""

import pathlib
import tempfile
import unittest

from tests.docs import examples, links
from tools.docs import pages


def read(text):
    return pages.examples_of(pages.blocks_of("page.md", text))


def fenced(body, above="", language="povray"):
    return f"Text\n\n{above}```{language}\n{body}\n```\n"


class Convention(unittest.TestCase):
    def test_whole_scene(self):
        (example,) = read(fenced("// tilt.pov: a board\n#version 3.7;\ncamera {}"))
        self.assertEqual((example.kind, example.name, example.block.line), ("whole", "tilt.pov", 3))

    def test_code_without_a_comment_is_refused(self):
        with self.assertRaisesRegex(pages.BadPage, r"page.md:3: code without #version .* is allowed"):
            read(fenced("tilt_lens { tilt 3 }"))

    def test_a_comment_farther_up_does_not_count(self):
        with self.assertRaises(pages.BadPage):
            read(fenced("tilt_lens { tilt 3 }", "<!-- example: camera items -->\n\n"))

    def test_kinds(self):
        for kind in ("camera items", "tilt_lens items", "scene", "not rendered, it is upstream's"):
            (example,) = read(fenced("tilt 3", f"<!-- example: {kind} -->\n"))
            self.assertEqual(example.kind, kind.split(",")[0])
        for kind in ("camera", "not rendered", "not rendered, ", "camera items; shouts: x", "camera items; says"):
            with self.assertRaises(pages.BadPage, msg=kind):
                read(fenced("tilt 3", f"<!-- example: {kind} -->\n"))

    def test_expectations(self):
        (example,) = read(fenced("tilt 3", "<!-- example: scene; says: f/4, 3; warns: a; warns: b -->\n"))
        self.assertEqual(example.expected, {"says": ["f/4, 3"], "warns": ["a", "b"], "fails": []})

    def test_two_scenes_of_one_name(self):
        with self.assertRaisesRegex(pages.BadPage, "two scenes are named a.pov"):
            read(fenced("// a.pov\n#version 3.7;") * 2)

    def test_open_fence(self):
        with self.assertRaisesRegex(pages.BadPage, "page.md:2: the fence is not closed"):
            read("Text\n```povray\ncamera {}\n")

    def test_fence_in_a_list(self):
        (example,) = read("- item\n\n  ```povray\n  #version 3.7;\n    sphere {}\n  ```\n")
        self.assertEqual(example.block.text, "#version 3.7;\n  sphere {}\n")

    def test_other_languages_are_no_examples(self):
        self.assertEqual(read(fenced("x", language="json")), [])


class Commands(unittest.TestCase):
    def test_found(self):
        text = "a\n\n    ./render a.pov +W640\n\n```sh\n$ cd x   # why\nmake \\\n  all\n# remark\n```\n\n```text\nno command\n```\n"
        self.assertEqual(pages.commands_of("p", text), [(3, "./render a.pov +W640"), (6, "cd x"), (7, "make all")])

    def test_rendered(self):
        self.assertEqual(
            examples.rendered_command("./render scenes/a.pov +W640 +H360 Declare=T=1 +A0.1", []), ("scenes/a.pov", ["Declare=T=1", "+A0.1"])
        )
        for command in ("./render SCENE.pov", "./render page.pov", "./check -L unit", "./render", "ls a.pov"):
            self.assertIsNone(examples.rendered_command(command, ["page.pov"]), command)

    def test_missing_program(self):
        self.assertEqual(
            list(links.check_commands("    ./render\n    cmake/setup.sh\n", "p")),
            ["line 2: 'cmake/setup.sh' runs cmake/setup.sh, which is not a program here"],
        )
        self.assertEqual(len(list(links.check_commands("    experiments/nothing --all\n", "p"))), 1)


class Links(unittest.TestCase):
    PAGE = "# A page, `code` & more\n\n## Twice\n## Twice\n\n```sh\n# not a heading\n```\n"

    def test_anchors(self):
        self.assertEqual(pages.anchors_of(self.PAGE), ["a-page-code--more", "twice", "twice-1"])

    def test_links(self):
        text = "[a](b.md#c) ![p](d.jpg)\n[long\ntext](e.md) `[no](f.md)`\n```\n[no](g.md)\n```\n<!-- [no](h.md)\n -->"
        self.assertEqual(pages.links_of(text), ["b.md#c", "d.jpg", "e.md"])

    def test_broken(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            page = pathlib.Path(name) / "page.md"
            page.write_text(self.PAGE)
            wrong = list(links.check_links(page, "[a](#twice) [b](page.md#twice-1) [c](#none) [d](e.jpg) [f](https://g)"))
        self.assertEqual(wrong, ["link to #none: no heading has that name", "link to e.jpg: there is no such file"])


class Outcome(unittest.TestCase):
    def wrong(self, above, code, said, picture):
        (example,) = read(fenced("tilt 3", above))
        return list(examples.wrong_with(example, code, said, picture))

    def test_well(self):
        self.assertEqual(self.wrong("<!-- example: camera items; says: f/4, all -->\n", 0, "f/4,\n all", True), [])
        self.assertEqual(self.wrong("<!-- example: scene; warns: oh -->\n", 0, "Parse Warning: oh", True), [])
        self.assertEqual(self.wrong("<!-- example: scene; fails: no -->\n", 1, "Parse Error: no", False), [])

    def test_each_fault(self):
        plain = "<!-- example: scene -->\n"
        for above, code, said, picture in (
            (plain, 1, "", False),
            (plain, None, "", True),
            (plain, 0, "", False),
            (plain, 0, "Parse Warning: oh", True),
            ("<!-- example: scene; says: a -->\n", 0, "b", True),
            ("<!-- example: scene; warns: a -->\n", 0, "a", True),
            ("<!-- example: scene; fails: a -->\n", 0, "a", True),
            ("<!-- example: scene; fails: a -->\n", 1, "b", False),
        ):
            self.assertTrue(self.wrong(above, code, said, picture), f"{above} {code} {said} {picture}")


if __name__ == "__main__":
    unittest.main()
