#!/usr/bin/env python3
"""Builds tests/cmake/consumer outside the tree, and checks that after a change exactly the outdated files are rebuilt.

    consumer_test.py subdirectory SOURCE_TREE          Glift by add_subdirectory
    consumer_test.py prebuilt SOURCE_TREE GLIFTC       the same, with a gliftc that is built already
    consumer_test.py package SOURCE_TREE BUILD_TREE    Glift by find_package and by pkg-config, from an installation of BUILD_TREE
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time


numbers_printed = "0 2 4 6 8 10 12 14 1 1 1 1 0 0 0 0".split()


def run(*command, **options):
    result = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            **options)
    if result.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{result.stdout}")
    return result.stdout


def expect(condition, what):
    if not condition:
        sys.exit(f"not so: {what}")
    print(f"so: {what}")


class Consumer:
    def __init__(self, folder, settings):
        self.source = folder / "a consumer"  # paths with spaces
        self.build_dir = folder / "its build"
        folder.mkdir(exist_ok=True)
        shutil.copytree(pathlib.Path(__file__).parent / "consumer", self.source)
        run("cmake", "-G", "Ninja", "-S", self.source, "-B", self.build_dir, "-DCMAKE_BUILD_TYPE=Release", *settings)

    def build(self):
        # Waits for longer than the granularity of file time stamps, so that the build sees every change.
        time.sleep(0.05)
        return run("cmake", "--build", self.build_dir, "--target", "consumer")

    def output(self):
        return run(self.build_dir / "consumer").split()

    def stamp(self, name):
        return (self.build_dir / "glift" / "consumer" / name).stat().st_mtime_ns

    def object(self, name):
        return next(self.build_dir.rglob(f"{name}.cpp.o")).stat().st_mtime_ns

    def times(self):
        """The time stamps of gliftc's last run and of the object files of its outputs."""
        objects = [f"{name}.glift{part}" for name in ("scale", "shift") for part in ("", ".library", ".kernels", ".library.kernels")]
        return {"gliftc run": self.stamp("scale.stamp")} | {name: self.object(name) for name in objects}

    def changed_by(self, action):
        before = self.times()
        action()
        self.build()
        after = self.times()
        return {name for name in before if before[name] != after[name]}


def check(consumer):
    consumer.build()
    numbers = consumer.output()
    expect(numbers == numbers_printed, f"the program computes ({' '.join(numbers)})")
    expect("no work to do" in consumer.build(), "a second build does nothing")

    imported = consumer.source / "imports" / "factor.glift"
    changed = consumer.changed_by(lambda: imported.touch())
    expect(changed == {"gliftc run"}, f"touching an import runs gliftc and compiles no C++ ({sorted(changed)})")
    expect("no work to do" in consumer.build(), "a build after a touch does nothing")

    changed = consumer.changed_by(lambda: imported.write_text(imported.read_text().replace("2.0", "3.0")))
    expect(changed == {"gliftc run", "scale.glift.kernels"},
           f"changing an import rebuilds what depends on it, and only that ({sorted(changed)})")
    expect(consumer.output()[:4] == "0 3 6 9".split(), "the program computes with the new import")
    expect("no work to do" in consumer.build(), "a build after a change does nothing")

    run("cmake", "-DGLIFT_SPIRV_FILES=OFF", consumer.build_dir)
    consumer.build()
    expect(consumer.output()[:4] == "0 3 6 9".split(), "SPIR-V within the sources gives the same program")
    expect("no work to do" in consumer.build(), "a build after that does nothing")

    for output in sorted((consumer.build_dir / "glift" / "consumer").glob("*.glift.*")):
        expect(str(consumer.source) not in output.read_text(errors="replace"), f"{output.name} holds no absolute path")


def check_refusals(folder, settings):
    """Projects that call glift_compile wrongly: CMake ends with an error that names the remedy."""
    def refused(name, lists, message):
        project = folder / name
        shutil.copytree(pathlib.Path(__file__).parent / "consumer", project)
        (project / "part").mkdir()
        shutil.copy(project / "shift.glift", project / "part" / "scale.glift")
        text = (project / "CMakeLists.txt").read_text()
        (project / "CMakeLists.txt").write_text(text[:text.index("glift_compile")] + lists)
        (project / "part" / "CMakeLists.txt").write_text("glift_compile(TARGET consumer SOURCES scale.glift)\n")
        result = subprocess.run(["cmake", "-G", "Ninja", "-S", project, "-B", folder / (name + " build"), *settings],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        said = " ".join(result.stdout.split())
        expect(result.returncode != 0 and message in said, f"{name}: CMake says '{message}'")

    refused("another folder", "add_subdirectory(part)\n", "call it in the folder that makes the target 'consumer'")
    refused("one name", "glift_compile(TARGET consumer SOURCES scale.glift part/scale.glift IMPORT_DIRS imports)\n",
            "Rename one of them")


def check_flags(folder, settings):
    """Programs with flags of their own compute the same."""
    for name, flags in {
        "fast math": ["-DCMAKE_CXX_FLAGS=-ffast-math"],
        "clang with a precompiled header": [
            "-DCMAKE_C_COMPILER=clang-14", "-DCMAKE_CXX_COMPILER=clang++-14", "-DPRECOMPILED=<vector>"],
    }.items():
        consumer = Consumer(folder / name, settings + flags)
        consumer.build()
        expect(consumer.output() == numbers_printed, f"{name}: the program computes ({' '.join(consumer.output())})")


def check_pkg_config(folder, prefix):
    """Builds the same program without CMake, with the flags that pkg-config gives for Glift's headers and library."""
    made, program = folder / "made", folder / "program"
    source = pathlib.Path(__file__).parent / "consumer"
    libraries = [str(p.parent) for p in prefix.rglob("glift.pc")]
    environment = {**os.environ, "PKG_CONFIG_PATH": ":".join(libraries)}

    def pkg_config(*words):
        return run("pkg-config", *words, "glift", env=environment).split()

    run(*pkg_config("--variable=gliftc"), "-o", made, "--target=cpp", "--target=host", "-I", source / "imports",
        source / "scale.glift", source / "shift.glift")
    run("c++", "-std=c++20", "-I", made, source / "main.cpp", *made.glob("*.cpp"), *pkg_config("--cflags", "--libs"),
        "-o", program)
    libdir = pkg_config("--variable=libdir")[0]
    expect(run(program, env={**environment, "LD_LIBRARY_PATH": libdir}).split() == numbers_printed,
           "a program built by pkg-config alone computes")


def main():
    mode, source = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory(prefix="glift-consumer-") as name:
        folder = pathlib.Path(name)
        if mode == "subdirectory":
            # This builds the compiler again, too, without optimisation: its speed does not matter here.
            settings = [f"-DGLIFT_SOURCE={source}", "-DCMAKE_CXX_FLAGS_RELEASE=-O0"]
        elif mode == "prebuilt":
            settings = [f"-DGLIFT_SOURCE={source}", f"-DGLIFT_GLIFTC={sys.argv[3]}", "-DCMAKE_CXX_FLAGS_RELEASE=-O0"]
            # Simulates a machine that has none of the compiler's dependencies.
            settings += [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in (
                "SPIRV-Tools-opt", "SPIRV-Tools-link", "glslang", "fmt", "CLI11", "nlohmann_json", "LLVM", "Clang", "GTest")]
        else:
            prefix = folder / "installed"
            run("cmake", "--install", sys.argv[3], "--prefix", prefix)
            settings = [f"-DCMAKE_PREFIX_PATH={prefix}"]
            check_pkg_config(folder, prefix)
            check_refusals(folder, settings)
            check_flags(folder, settings)
            of_build_tree = Consumer(folder / "of the build tree", [f"-Dglift_DIR={sys.argv[3]}"])
            of_build_tree.build()
            expect(of_build_tree.output() == numbers_printed, "find_package takes the build tree, not installed")
        check(Consumer(folder, settings))


os.environ.pop("GLIFT_STDLIB", None)  # an installed gliftc must find its library by itself
main()
