# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The version stands in CMakeLists.txt; what else names it agrees. The recipes can be read, and name what there is."""

import ast
import re

import pytest
import yaml

pytestmark = pytest.mark.built_in


@pytest.fixture(scope="module")
def version(root):
    (found,) = re.findall(r"^project\(POTDEM VERSION (\d+\.\d+\.\d+) ", (root / "CMakeLists.txt").read_text(), re.MULTILINE)
    return found


def text_of(root, name):
    return (root / name).read_text(encoding="utf-8")


def conda_recipe(root):
    """the recipe as YAML, once its templates are words"""
    return yaml.safe_load(re.sub(r"\{\{ *(\w+)\('(\w+)'\) *\}\}", r"\1_\2", text_of(root, "packaging/conda/meta.yaml")))


def test_changes_begin_with_the_version(root, version):
    assert re.findall(r"^## (.*)$", text_of(root, "CHANGELOG.md"), re.MULTILINE)[0] == version


def test_citation_has_the_version_and_what_the_readme_asks_to_cite(root, version):
    citation = yaml.safe_load(text_of(root, "CITATION.cff"))
    assert citation["version"] == version and {"cff-version", "message", "title", "authors"} <= set(citation)
    readme = text_of(root, "README.md").split("## How to cite")[1].replace("\n> ", " ")
    assert citation["references"] and all(work["title"] in readme for work in citation["references"])


def test_the_plugin_names_the_version(build, run_lammps, version):
    text = run_lammps(f"plugin load {build}/potdemplugin.so\n").stdout
    assert f"Loading plugin: potdem/truss by POTDEM {version}\n" in text


def test_conda_recipe(root, version):
    recipe = conda_recipe(root)
    assert recipe["package"] == {"name": "potdem", "version": version}
    assert any(source.get("url") in text_of(root, "cmake/LAMMPSFetch.cmake") for source in recipe["source"] if "url" in source)
    assert (root / "packaging" / "conda" / recipe["source"][0]["path"] / "CMakeLists.txt").exists()


def test_spack_recipe(root, version):
    folder = root / "packaging" / "spack"
    assert yaml.safe_load((folder / "repo.yaml").read_text())["repo"]["namespace"] == "potdem"
    tree = ast.parse((folder / "packages" / "potdem" / "package.py").read_text())
    calls = [(call.func.id, [arg.value for arg in call.args if isinstance(arg, ast.Constant)], {k.arg: k.value for k in call.keywords})
             for call in ast.walk(tree) if isinstance(call, ast.Call) and isinstance(call.func, ast.Name)]
    assert [args for name, args, _ in calls if name == "version"] == [[version]]
    (resource,) = [words for name, _, words in calls if name == "resource"]
    assert f"tags/{resource['tag'].value}.tar.gz" in text_of(root, "cmake/LAMMPSFetch.cmake")


@pytest.mark.parametrize("recipe", ["packaging/conda/meta.yaml", "packaging/spack/packages/potdem/package.py", "Containerfile"])
def test_recipes_build_and_install_what_there_is(root, recipe):
    """targets, the component, the folders that they copy"""
    text, cmake = text_of(root, recipe), "".join(path.read_text() for path in (root / "cmake").glob("POTDEM*.cmake"))
    assert re.search(r"--component\W+potdem\b", text) and "COMPONENT potdem" in cmake
    if "potdemplugin" in text:
        assert "potdem_plugin(potdemplugin" in cmake and re.search(r"\blmp\W+potdemplugin\b", text)
    else:
        assert "bootstrap yes" in text and re.search(r"^bootstrap\(\)", text_of(root, "tools/bootstrap.sh"), re.MULTILINE)


def test_workflow_runs_the_two_commands_of_the_readme(root):
    workflow = yaml.safe_load(text_of(root, ".github/workflows/ci.yml"))
    (job,) = workflow["jobs"].values()
    commands = re.findall(r"^((?:examples|unittest)/run.*)$", text_of(root, "README.md").split("## Two commands")[1], re.MULTILINE)
    run = [step["run"] for step in job["steps"] if "run" in step]
    assert len(commands) == 2 and run[-2:] == commands
    assert job["container"] == "debian:12" and "Debian 12" in text_of(root, "README.md")
