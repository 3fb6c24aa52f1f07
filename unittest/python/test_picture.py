# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the pictures of the scenes have in common: words, panels, files."""

import numpy as np
import pictures
import pytest
import vtk_files
from PIL import Image

from potdem import paraview, picture
from potdem.paths import DOCS, EXAMPLES
from potdem.scenes import scene as scenes


def frames(last, step=0.1):
    """of one particle, until a time"""
    return [{"time": time, "x": np.array([time]), "y": np.zeros(1), "z": np.zeros(1), "radius": np.full(1, 0.1)}
            for time in np.arange(0, last + step / 2, step)]


class Film(picture.Film):
    """folders are the times at which the runs end"""

    def frames(self, folder):
        return frames(float(folder))


@pytest.fixture
def film():
    def draw(axis, frame):
        picture.particles(axis, frame, scale(frame["x"]))

    scale = picture.Scale("speed", 0, 1, "place, m")
    return Film("", draw, scale, (-0.2, 1.2, -0.4, 0.2), (0.5, (0, 0, -0.2)))


@pytest.mark.parametrize("seconds, words", [(0, "0 s"), (1.2e-4, "0.12 ms"), (0.016, "0.016 s"), (0.2000001, "0.2 s"), (1.47, "1.47 s")])
def test_times_are_told_in_words(seconds, words):
    assert picture.time_words(seconds) == words


@pytest.mark.parametrize("metres, words", [(2.0, "2 m"), (0.3, "30 cm"), (0.01, "1 cm"), (0.005, "5 mm")])
def test_lengths_are_told_in_words(metres, words):
    assert picture.length_words(metres) == words


def test_settings_of_a_run_are_those_of_its_variant_and_of_the_script(tmp_path):
    variant = scenes.Scene("hopper").variant("rough")
    found = picture.settings(tmp_path / "hopper" / variant.output(2).name)
    assert float(found["mu_grain"]) == 0.3 and float(found["damping"]) == 0.2
    assert picture.settings(tmp_path / "hopper" / "of-a-scan") == picture.settings(tmp_path) == {}


def test_a_kind_of_quantity_has_one_colour_map():
    one, other = (picture.Scale("strain", -limit, limit, "") for limit in (0.1, 2.0))
    assert np.all(one(np.array([-0.1, 0.0, 0.1])) == other(np.array([-2.0, 0.0, 2.0])))


def titles(axes):
    return [axis.get_title("left") for axis in axes.ravel()]


def test_columns_are_runs_and_rows_are_instants(film):
    figure, below = film.at_instants(["1.0", "0.4"], [0.2, 0.7, 3.0], below=(1.0,))
    panels = np.array(figure.axes[:6]).reshape(3, 2)
    assert titles(panels[:2]) == ["0.2 s", "0.2 s", "0.7 s", ""], "no row for what no run reaches"
    assert [text.get_text() for text in panels[1, 1].texts] == ["the run ends at 0.4 s"]
    assert [axis.get_title("center").strip() for axis in panels[0]] == ["1.0", "0.4"]
    assert [len(row) for row in below] == [2]


def test_the_instants_of_one_run_come_side_by_side(film):
    figure, below = film.at_instants(["1.0"], [0.1, 0.5, 1.0], below=(1.0, 2.0))
    panels = figure.axes[:3]
    assert [len(row) for row in below] == [1, 1] and titles(np.array(panels)) == ["0.1 s", "0.5 s", "1 s"]
    assert len({panel.get_position().y0 for panel in panels}) == 1
    assert figure._suptitle.get_text() == "1.0"


def test_a_frame_is_drawn_in_place_of_the_one_before(film):
    figure, ((axis,),), _ = film.panels(1, 1)
    for frame in frames(0.2):
        film.show(axis, frame)
    assert len(axis.collections) == 1 and axis.get_title("left") == "0.2 s"
    (bar,) = axis.lines
    assert np.ptp(bar.get_xdata()) == pytest.approx(0.5)
    picture.plt.close(figure)


def test_a_bar_is_as_long_as_it_looks_in_a_slanted_view():
    figure, axis = picture.plt.subplots()
    picture.length_bar(axis, (0, 0, 0), 2.0, picture.SLANTED)
    drawn = np.column_stack(axis.lines[0].get_data())
    ends = picture.view(np.array([[0.0, 0, 0], [2.0, 0, 0]]), *picture.SLANTED)[:, :2]
    assert drawn == pytest.approx(ends) and axis.texts[0].get_text() == "2 m"
    picture.plt.close(figure)


def test_pictures_have_a_palette(tmp_path, film):
    picture.save(film.at_instants(["1.0"], [0.1])[0], tmp_path / "one.png")
    image = Image.open(tmp_path / "one.png")
    assert image.mode == "P" and image.convert("RGB").getpixel((0, 0)) == (255, 255, 255)


def test_an_animation_rests_at_its_end_and_stays_white(tmp_path, film):
    film.animate("1.0", tmp_path / "film.gif")
    image = Image.open(tmp_path / "film.gif")
    assert image.n_frames == len(frames(1.0))
    assert image.info["duration"] == 1000 // picture.FRAMES_PER_SECOND
    image.seek(image.n_frames - 1)
    assert image.info["duration"] == 1000 and image.convert("RGB").getpixel((0, 0)) == (255, 255, 255)


def test_what_a_whole_frame_has_is_no_value_of_its_particles(tmp_path):
    written = paraview.write([{**frame, "way": 0.1} for frame in frames(0.2)], tmp_path / "vtk", "one")
    assert [list(blocks["particles"].data) for _, blocks in vtk_files.series(written)] == [["radius"]] * 3


def test_pictures_of_the_pages_are_made_by_one_command():
    assert pictures.script_of_see().startswith("units           si")
    paths = [drawn.path for drawn in pictures.PICTURES]
    assert sorted([*paths, EXAMPLES / "recipes" / "recipes.png"]) == sorted(EXAMPLES.glob("*/*.png"))
    for drawn in pictures.PICTURES:
        scene = scenes.Scene(drawn.scene)
        assert (scene.folder / drawn.program.split()[0]).exists()
        assert all(name in scene.variants for name in drawn.variants)


def test_animations_of_the_pages_are_made_by_one_command():
    assert sorted(pictures.ANIMATIONS) == sorted(path.name for path in DOCS.glob("*.gif"))
    for shown in pictures.ANIMATIONS.values():
        for scene, variant, until, _ in shown:
            assert variant in scenes.Scene(scene).variants and until > 0


def test_an_unknown_scene_has_no_picture():
    with pytest.raises(SystemExit, match="no pictures of fligth; there are: bar-strength.*animation, see, recipes"):
        pictures.main("fligth")
