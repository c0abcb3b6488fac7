# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Kernels for AVX2 define no function that the linker might use elsewhere, and load and store registers without a call.

usage: test_kernel_symbols COMPILER NM OBJECTS OBJECTS, the kernels as built and without optimisation; empty: none."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

NAMESPACE = "9tilt_lens4avx2"


def shared_symbols(nm, objects):
    command = [nm, "--defined-only", "--extern-only", "--format=just-symbols", *objects]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    symbols = [line for line in listed.splitlines() if line and not line.endswith(":")]
    outside = "\n".join(sorted({symbol for symbol in symbols if NAMESPACE not in symbol}))
    return len(symbols), subprocess.run(["c++filt"], input=outside, capture_output=True, text=True, check=True).stdout.splitlines()


class KernelSymbols(unittest.TestCase):
    compiler = nm = ""
    objects = ()

    def test_kernels_share_no_function(self):
        if not self.objects:
            self.skipTest("this build has no kernels for AVX2, or has sanitizers")
        for objects in self.objects:
            number, shared = shared_symbols(self.nm, objects)
            self.assertGreater(number, len(objects), "each file defines a kernel")
            self.assertEqual(shared, [], "mark these functions TILT_LENS_INLINED, or do without them")

    def test_registers_are_loaded_without_a_call(self):
        if not self.objects:
            self.skipTest("this build has no kernels for AVX2, or has sanitizers")
        command = [self.nm, "--undefined-only", "--format=just-symbols", *self.objects[0]]
        needed = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
        self.assertNotIn("__memcpy_chk", needed, "Load() and Store() of math/simd.h are calls")

    def test_a_shared_function_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            source, compiled = pathlib.Path(folder, "kernel.cpp"), pathlib.Path(folder, "kernel.o")
            source.write_text(
                "#include <algorithm>\nnamespace tilt_lens::avx2 {\nfloat Greater(float a, float b) { return std::max(a, b); }\n}\n"
            )
            subprocess.run([self.compiler, "-std=c++17", "-O0", "-c", source, "-o", compiled], check=True)
            number, shared = shared_symbols(self.nm, [compiled])
        self.assertEqual(number, 2)
        self.assertEqual(len(shared), 1)
        self.assertIn("std::max<float>", shared[0])


if __name__ == "__main__":
    *start, KernelSymbols.compiler, KernelSymbols.nm, built, unoptimised = sys.argv
    KernelSymbols.objects = [objects.split(";") for objects in (built, unoptimised) if objects]
    unittest.main(argv=start)
