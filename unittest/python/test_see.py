# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/see: stills, films and files for ParaView of any dump."""

import re
import shlex
import shutil
import subprocess

import numpy as np
import pytest
import vtk_files
from PIL import Image

from potdem import commands, dumps, logs, look, plot, regions, running, see, stl
from potdem.paths import DOCS, ROOT
from potdem.text import replaced

# hues of the types 2, 3, 4, 5
HUES = {2: lambda r, g, b: (r > g + 60) & (r > b + 50), 3: lambda r, g, b: (b > r + 60) & (b > g + 25),
        4: lambda r, g, b: (g > r + 40) & (g > b + 20), 5: lambda r, g, b: (b > g + 25) & (r > g + 10) & (b > r + 15)}
COLUMNS = "id type x y z radius"


def frame(step, rows, columns=COLUMNS, box="ff ff ff", bounds=((-10, 10),) * 3, kind="ATOMS"):
    sides = "\n".join(f"{low} {high}" for low, high in bounds)
    return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF {kind}\n{len(rows)}\nITEM: BOX BOUNDS {box}\n{sides}\nITEM: {kind} {columns}\n" +
            "".join(" ".join(f"{value}" for value in row) + "\n" for row in rows))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def pixels(path, kind):
    """(x to the right, y up) of the pixels with the hue of a type, without the legend"""
    image = np.asarray(Image.open(path).convert("RGB")).astype(int)
    r, g, b = image[: int(0.85 * len(image))].transpose(2, 0, 1)
    rows, columns = np.nonzero(HUES[kind](r, g, b))
    return np.column_stack([columns, -rows])


def centre(path, kind):
    found = pixels(path, kind)
    assert len(found) > 100, f"no particle of type {kind}"
    return found.mean(axis=0)


def test_particles_are_where_they_are_from_the_front(folder):
    rows = [(1, 2, 0, 0, 0, 0.5), (2, 3, 4, 1, 0, 0.5), (3, 4, 0, 2, 2, 0.25)]
    (folder / "run.dump").write_text(frame(0, rows))
    see.main(["run.dump", "--view", "0", "0"])
    at = {kind: centre("run.png", kind) for kind in (2, 3, 4)}
    scale = (at[3] - at[2])[0] / 4
    # highlights have another hue, so that centres are off by up to a tenth of a radius
    assert at[3] - at[2] == pytest.approx([4 * scale, 0], abs=0.05 * scale)
    assert at[4] - at[2] == pytest.approx([0, 2 * scale], abs=0.05 * scale)
    for kind, radius in ((2, 0.5), (4, 0.25)):
        assert np.ptp(pixels("run.png", kind)[:, 0]) == pytest.approx(2 * radius * scale, rel=0.05)


def test_a_slanted_view_is_a_turn_about_z_and_a_tilt(folder):
    places = {2: (0, 0, 0), 3: (4, 0, 0), 4: (0, 3, 0), 5: (0, 0, 3)}
    (folder / "run.dump").write_text(frame(0, [(kind, kind, *place, 0.4) for kind, place in places.items()]))
    see.main(["run.dump", "--view", "-30", "20"])
    at = {kind: centre("run.png", kind) - centre("run.png", 2) for kind in places}
    c, s, tilt_c, tilt_s = np.cos(np.pi / 6), 0.5, np.cos(np.pi / 9), np.sin(np.pi / 9)
    scale = at[3][0] / (4 * c)
    assert at[3] / scale == pytest.approx([4 * c, -4 * s * tilt_s], abs=0.06)
    assert at[4] / scale == pytest.approx([3 * s, 3 * c * tilt_s], abs=0.06)
    assert at[5] / scale == pytest.approx([0, 3 * tilt_c], abs=0.06)


def test_the_near_hides_the_far(folder):
    rows = [(1, 2, 0, -3, 0, 1), (2, 3, 0, 3, 0, 1), (3, 4, 4, 0, 0, 1)]
    for front, turn in ((2, "0"), (3, "180")):
        (folder / "run.dump").write_text(frame(0, rows))
        see.main(["run.dump", "--view", turn, "0"])
        assert len(pixels("run.png", front)) > 1000 and len(pixels("run.png", 5 - front)) == 0


def test_the_command_tells_of_itself():
    done = subprocess.run([ROOT / "tools" / "see", "--help"], capture_output=True, text=True, check=True)
    assert "--film [FILE.mp4]" in done.stdout


def test_a_plane_is_seen_from_above_and_a_long_body_from_its_side():
    flat = [dumps.Frame(0, {"x": np.array([0.0, 1]), "y": np.array([0.0, 2]), "z": np.zeros(2)})]
    long = [dumps.Frame(0, {"x": np.zeros(2), "y": np.array([0.0, 9]), "z": np.array([0.0, 1])})]
    assert look.direction_of(flat) == (0, 90)
    assert look.direction_of(long)[0] == pytest.approx(66)


def log_of(*lines, dump="run.dump"):
    return "\n".join(["LAMMPS (4 Feb 2025 - Update 1)", "units si", *lines, f"dump d all custom 10 {dump} {COLUMNS}",
                      "timestep 0.001", "Loop time of 1 on 1 procs for 10 steps with 2 atoms"]) + "\n"


FLOOR = ("region floor plane 0 0 -2 0 0 1 units box", "fix f all potdem/wall/region floor 1e5 0.2 particle 1e5 0.2")
LID = ("region lid plane 0 0 2 0 0 -1 units box", "fix l all wall/gran/region hooke/history 1 1 1 1 0 1 region lid")


def grey_share(path):
    """of pixels in the tint of walls"""
    image = np.asarray(Image.open(path).convert("RGB")).astype(int)
    tint = np.array([0xe7, 0xe3, 0xdc]) / 0xe7
    shade = image[..., 0:1]
    return np.mean((abs(image - shade * tint).max(axis=2) < 3) & (shade[..., 0] > 150) & (shade[..., 0] < 245))


PLANES = "fix w all wall/gran hooke/history 1 NULL 1 NULL 0.5 1 zplane {} {}"


@pytest.mark.parametrize("walls, drawn", [
    ((), False), (FLOOR, True), (LID, False), ((*FLOOR, "unfix f"), False),
    ([PLANES.format("-2", "NULL")], True), ([PLANES.format("NULL", "2")], False)])
def test_walls_behind_the_particles_are_drawn(folder, walls, drawn):
    """seen from above a floor is behind them, a lid would hide them; a fix that has ended is no wall"""
    (folder / "run.dump").write_text(frame(10, [(1, 2, 0, 0, -1.5, 0.5), (2, 2, 3, 0, 1, 0.5)]))
    (folder / "log.lammps").write_text(replaced(log_of(*walls), "unfix f\n", "") if "unfix f" in walls else log_of(*walls))
    if "unfix f" in walls:
        with (folder / "log.lammps").open("a") as log:
            log.write("unfix f\n")
        (folder / "run.dump").write_text(frame(20, [(1, 2, 0, 0, -1.5, 0.5), (2, 2, 3, 0, 1, 0.5)]))
    see.main(["run.dump", "--view", "0", "45"])
    assert (grey_share("run.png") > 0.1) == drawn


@pytest.mark.parametrize("binary", [True, False])
@pytest.mark.parametrize("side", ["in", "out"])
def test_triangles_are_drawn_as_the_block_that_they_make(folder, side, binary):
    """the areas of its faces, in millimetres, by their normals to the side of the particles; a sheet has both"""
    stl.write(folder / "box.stl", stl.box([-2000, -2000, -2000], [4000, 2000, 2000], 3), binary)
    stl.write(folder / "sheet.stl", stl.rectangle([-2, -2, -2], [6, 0, 0], [0, 4, 0]), binary)
    (folder / "log.lammps").write_text(log_of(f"region b block -2 4 -2 2 -2 2 side {side} units box",
                                              f"region m potdem/mesh box.stl scale 0.001 side {side} units box",
                                              "region s potdem/mesh sheet.stl units box"))
    found = commands.of_log(folder / "log.lammps").regions
    room = regions.Room(np.array([-9.0, -9, -9]), np.array([9.0, 9, 9]))

    def areas(name):
        tiles, normals = regions.surface(name, found, room)
        each = 0.5 * np.linalg.norm(np.cross(tiles[:, 2] - tiles[:, 0], tiles[:, 3] - tiles[:, 1]), axis=1)
        return {tuple(face): each[np.all(np.isclose(normals, face), axis=1)].sum() for face in (*np.eye(3), *-np.eye(3))}

    assert sorted(areas("b").values()) == pytest.approx([16, 16, 24, 24, 24, 24])
    assert areas("m") == pytest.approx(areas("b"), rel=1e-6)
    assert areas("s") == pytest.approx({**dict.fromkeys(areas("b"), 0.0), (0, 0, 1): 24, (0, 0, -1): 24})


@pytest.mark.parametrize("binary", [True, False])
def test_stl_files_are_read_as_they_were_written(folder, binary):
    ball = stl.sphere([0.5, 1, 2], 3, 4)
    stl.write(folder / "ball.stl", ball, binary)
    assert np.max(abs(stl.read(folder / "ball.stl") - ball)) < (1e-6 if binary else 1e-300)
    assert stl.is_closed(ball) and not stl.is_closed(ball[1:])
    (folder / "none.stl").write_text("nothing")
    with pytest.raises(ValueError, match="no STL file"):
        stl.read(folder / "none.stl")


def test_a_wall_on_edge_is_a_line_where_it_is(folder):
    """the floor 2 below particles 4 apart"""
    (folder / "run.dump").write_text(frame(0, [(1, 2, 0, 0, 0, 0.5), (2, 3, 4, 0, 0, 0.5)]))
    (folder / "log.lammps").write_text(log_of(*FLOOR, "region low plane 0 0 -0.7 0 0 1 units box", FLOOR[1].replace("floor", "low")))
    see.main(["run.dump", "--view", "0", "0"])
    left, right = centre("run.png", 2), centre("run.png", 3)
    image = np.asarray(Image.open("run.png").convert("RGB")).astype(int)
    rows = np.nonzero(np.mean(abs(image - [0xb9, 0xc2, 0xc9]).max(axis=2) < 4, axis=1) > 0.5)[0]
    # of the two with one ID of fix the later counts
    assert -rows.mean() - left[1] == pytest.approx(-0.7 / 4 * (right - left)[0], rel=0.05)


def test_the_log_says_what_the_script_was(folder):
    log = folder / "log.lammps"
    log.write_text(log_of("lattice sc 0.5", "Lattice spacing in x,y,z = 0.5 0.5 0.5",
                          "region box block 0 ${n} 0 2 0 2", "region box block 0 4 0 2 0 2",
                          'if "${walls} == yes" then &', '  "region a plane 0 0 0 0 0 1" "fix a all wall/region a lj93 1 1 1"', *FLOOR,
                          "compute s all potdem/strain/atom  # strains", "fix c all potdem/failure 1 tension 1"))
    run = commands.of_log(log)
    assert run.units == "si" and run.dt == 0.001 and run.wrote("elsewhere/run.dump") and not run.wrote("other.dump")
    assert run.regions["box"].words == ["block", "0", "4", "0", "2", "0", "2"] and run.regions["box"].scale[0] == 0.5
    assert run.regions["floor"].scale[0] == 1 and "a" not in run.regions
    assert run.walls_at(0) == ["floor"]
    assert run.label("c_s[1]") == "strain xx" and run.label("f_c[1]") == "fracture energy, J" and run.label("vx") == "vx, m/s"


@pytest.mark.parametrize("words, area", [
    ("plane 0 0 0.2 0 0 1", 1.0), ("plane 0.5 0.5 0.5 1 1 0", 2**0.5), ("block 0.2 0.8 INF INF 0.3 INF side out", 2.0),
    ("sphere 0.5 0.5 0.5 0.3", 4 * np.pi * 0.09), ("cylinder z 0.5 0.5 0.4 INF 0.9", 2 * np.pi * 0.4 * 0.9 + np.pi * 0.16),
    ("cone z 0.5 0.5 0.1 0.4 0.1 0.9", np.pi * (0.5 * np.hypot(0.8, 0.3) + 0.01 + 0.16))])
def test_regions_have_their_surface_in_a_unit_room(words, area):
    """tiles across the room's edge are left out as a whole, which costs an oblique plane up to a tile at each edge"""
    room = regions.Room(np.zeros(3), np.ones(3))
    tiles, normals = regions.surface("r", {"r": commands.Region(words.split(), np.ones(3))}, room)
    found = 0.5 * np.linalg.norm(np.cross(tiles[:, 2] - tiles[:, 0], tiles[:, 3] - tiles[:, 1]), axis=1).sum()
    assert found == pytest.approx(area, rel=0.06 if "1 1 0" in words else 0.002)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0)


def test_members_of_an_intersection_hide_each_other():
    """a step: a floor at 0.2 and a block that stands on it, both in the room; the floor below the block is left out"""
    every = {"floor": commands.Region("plane 0 0 0.2 0 0 1".split(), np.ones(3)),
             "block": commands.Region("block 0.5 INF INF INF INF 0.6 side out".split(), np.ones(3)),
             "both": commands.Region("intersect 2 floor block".split(), np.ones(3))}
    tiles, normals = regions.surface("both", every, regions.Room(np.zeros(3), np.ones(3)))
    area = 0.5 * np.linalg.norm(np.cross(tiles[:, 2] - tiles[:, 0], tiles[:, 3] - tiles[:, 1]), axis=1)
    # half of the floor, the block's side above it (whole tiles of 1/24) and its top
    assert area.sum() == pytest.approx(0.5 + 0.4 + 0.5, abs=0.05)
    up = area[normals[:, 2] > 0.99].sum()
    assert up == pytest.approx(1.0, abs=0.01) and area[normals[:, 0] < -0.99].sum() == pytest.approx(0.4, abs=0.05)


def test_a_wall_moves_by_its_column_of_the_thermo_output(folder):
    region = "region blade plane 0 0 -2 0 0 1 move NULL NULL v_way units box"
    (folder / "run.dump").write_text(frame(0, [(1, 1, 0, 0, 0, 1)]) + frame(10, [(1, 1, 0, 0, 0, 1)]))
    text = log_of(region, FLOOR[1].replace("floor", "blade"))
    (folder / "log.lammps").write_text(replaced(text, "Loop time", "   Step   v_way\n   0   0\n   10   1.5\nLoop time"))
    view = see.Seen(see.parse(["run.dump"])).view()
    view.room = regions.Room(np.full(3, -3.0), np.full(3, 3.0))
    assert view.tiles(0).corners[..., 2] == pytest.approx(-2) and view.tiles(10).corners[..., 2] == pytest.approx(-0.5)
    view.thermo = None
    assert view.tiles(10).corners[..., 2] == pytest.approx(-2)
    assert view.not_drawn == {"region blade moves, and is drawn where it starts: put v_way into thermo_style custom"}


def probed(path):
    text = subprocess.check_output(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                                    "stream=nb_read_frames,width,height,codec_name,pix_fmt", "-of", "default=nw=1", path], text=True)
    return dict(line.split("=") for line in text.split())


def test_a_film_has_every_frame(folder, capsys):
    (folder / "run.dump").write_text("".join(frame(10 * k, [(1, 2, k, 0, 0, 1), (2, 3, 9, 0, 2, 1)]) for k in range(7)))
    see.main(["run.dump", "--film"])
    found = probed("run.mp4")
    assert found["nb_read_frames"] == "7" and (found["codec_name"], found["pix_fmt"]) == ("h264", "yuv420p")
    assert "7 frames" in capsys.readouterr().out
    see.main(["run.dump", "--film", "short.mp4", "--every", "3"])
    assert probed("short.mp4")["nb_read_frames"] == "3"
    subprocess.run(["ffmpeg", "-loglevel", "error", "-i", "run.mp4", "%d.png"], check=True)
    first, last = centre("1.png", 2), centre("7.png", 2)
    assert last[0] > first[0] + 100 and centre("1.png", 3) == pytest.approx(centre("7.png", 3), abs=2)


def test_without_ffmpeg_the_remedy_is_named(folder, monkeypatch):
    (folder / "run.dump").write_text(frame(0, [(1, 2, 0, 0, 0, 1)]))
    monkeypatch.setenv("PATH", "")
    with pytest.raises(look.SeeError, match="apt-get install ffmpeg"):
        see.main(["run.dump", "--film"])


def bonds_frame(step, rows):
    return frame(step, rows, "index batom1 batom2 c_state", kind="ENTRIES")


def test_bonds_are_lines_that_go_the_near_way_across_a_border(folder):
    bounds = ((0, 10), (0, 10), (0, 10))
    rows = [(7, 1, 0.5, 5, 5, 0.5), (3, 1, 9.5, 5, 5, 0.5), (5, 1, 2.0, 5, 5, 0.5)]
    (folder / "run.dump").write_text(frame(4, rows, box="pp ff ff", bounds=bounds))
    (folder / "b.dump").write_text(bonds_frame(4, [(1, 7, 3, 0.1), (2, 7, 5, -0.2), (3, 7, 99, 0.3)]))
    see.main(["run.dump", "--bonds", "b.dump", "--vtk", "out"])
    ((time, blocks),) = vtk_files.series("out/run.pvd")
    bonds = blocks["bonds"]
    assert time == 4, "the step, where no log gives the time"
    assert bonds.points == pytest.approx(np.array([[0.5, 5, 5], [-0.5, 5, 5], [0.5, 5, 5], [2, 5, 5]]))
    assert bonds.cells("Lines") == [[0, 1], [2, 3]], "that to a lost particle is left out"
    assert bonds.data["id1"].tolist() == [7, 7] and bonds.data["id2"].tolist() == [3, 5]
    assert bonds.data["c_state"] == pytest.approx([0.1, -0.2])


def test_files_for_paraview_have_particles_with_their_columns(folder):
    rows = [(2, 1, 1, 2, 3, 0.5, 7, 8, 9, 0.25), (1, 2, -1, 0, 1, 0.75, 1, 2, 3, -0.5)]
    (folder / "run.dump").write_text(frame(0, rows, COLUMNS + " vx vy vz c_s[1]") + frame(10, rows[:1], COLUMNS + " vx vy vz c_s[1]"))
    (folder / "log.lammps").write_text(log_of(*FLOOR))
    see.main(["run.dump", "--vtk"])
    frames = vtk_files.series("run.vtk/run.pvd")
    assert [time for time, _ in frames] == [0, 0.01]
    particles = frames[0][1]["particles"]
    assert particles.points == pytest.approx(np.array([row[2:5] for row in rows]))
    assert particles.cells("Verts") == [[0], [1]] and particles.data["id"].tolist() == [2, 1]
    assert particles.data["radius"] == pytest.approx([0.5, 0.75]) and particles.data["c_s[1]"] == pytest.approx([0.25, -0.5])
    assert particles.data["v"] == pytest.approx(np.array([[7, 8, 9], [1, 2, 3]])) and "vx" not in particles.data
    assert len(frames[1][1]["particles"].points) == 1
    walls = frames[0][1]["walls"]
    assert all(len(cell) == 4 for cell in walls.cells("Polys")) and walls.points[:, 2] == pytest.approx(-2)


def test_vtk_reads_what_is_written(folder):
    """VTK's own reader, of python3-vtk9 or python3-paraview; neither is needed to build or run, and the two exclude each other"""
    io = pytest.importorskip("vtkmodules.vtkIOXML", reason="neither python3-vtk9 nor python3-paraview is installed")
    (folder / "run.dump").write_text(frame(4, [(1, 1, 0, 0, 0, 0.5), (2, 1, 1, 0, 0, 0.5)]))
    (folder / "b.dump").write_text(bonds_frame(4, [(1, 1, 2, 0.125)]))
    see.main(["run.dump", "--bonds", "b.dump", "--vtk", "out"])
    reader = io.vtkXMLMultiBlockDataReader()
    reader.SetFileName("out/run.0000.vtm")
    reader.Update()
    particles, bonds = (reader.GetOutput().GetBlock(number) for number in range(2))
    assert particles.GetNumberOfPoints() == particles.GetNumberOfVerts() == 2 and particles.GetPoint(1) == (1, 0, 0)
    assert particles.GetPointData().GetArray("radius").GetValue(0) == 0.5
    assert bonds.GetNumberOfLines() == 1 and bonds.GetCellData().GetArray("c_state").GetValue(0) == 0.125


def test_contacts_that_do_not_touch_are_left_out(folder):
    (folder / "run.dump").write_text(frame(0, [(1, 1, 0, 0, 0, 0.5), (2, 1, 0.9, 0, 0, 0.5), (3, 1, 2.2, 0, 0, 0.5)]))
    (folder / "c.dump").write_text(frame(0, [(1, 1, 2, 5.0), (2, 2, 3, 0)], "index patom1 patom2 force", kind="ENTRIES"))
    links = see.Seen(see.parse(["run.dump", "--contacts", "c.dump"]))
    ends, table = links.drawn.at(links.frame(0))
    assert ends.tolist() == [[[0, 0, 0], [0.9, 0, 0]]] and table["force"].tolist() == [5.0]


@pytest.mark.parametrize("far", [0, 5000])
def test_a_bond_in_front_of_a_particle_is_seen_and_one_behind_it_is_not(folder, far):
    """wherever the origin is: the slabs in which is painted are those of what there is. The particle hides two thirds of the bond"""
    (folder / "b.dump").write_text(bonds_frame(0, [(1, 1, 2, 0.1)]))
    seen = []
    for y in (far - 5, far + 5):
        (folder / "run.dump").write_text(frame(0, [(1, 1, -2, y, 0, 0.6), (2, 1, 2, y, 0, 0.6), (3, 1, 0, far, 0, 2.97)]))
        see.main(["run.dump", "--bonds", "b.dump", "--view", "0", "0"])
        r, _, b = np.asarray(Image.open("run.png").convert("RGB")).astype(int)[:600].transpose(2, 0, 1)
        seen.append(np.sum(b > r + 60))
    assert seen[0] > 500 and 0.1 * seen[0] < seen[1] < 0.4 * seen[0]


@pytest.mark.parametrize("columns, rows, points", [
    ("id xs ys zs radius", [(1, 0.25, 0.5, 1.0, 1)], [2.5, 15, 30]), ("id xu yu zu diameter", [(1, 12.5, 1, 2, 2)], [12.5, 1, 2]),
    ("id element x y z radius", [(1, "Fe", 1, 2, 3, 1)], [1, 2, 3])])
def test_positions_come_in_any_of_lammps_forms(folder, columns, rows, points):
    (folder / "run.dump").write_text(frame(0, rows, columns, bounds=((0, 10), (10, 20), (20, 30))))
    found = look.placed(dumps.Dump("run.dump")[0], folder / "run.dump", None)
    assert look.points(found)[0] == pytest.approx(points) and found["radius"] == pytest.approx(1)


def test_a_tilted_box_has_its_edges():
    """LAMMPS's manual: bounds xlo+min(0,xy,xz,xy+xz), xhi+max(...), for xy = 2, xz = 1, yz = -1 of a box from 0 to 10"""
    box = dumps.Box.read("xy xz yz pp pp ff".split(), ["0 13 2", "-1 10 1", "0 10 -1"])
    assert box.low == pytest.approx(0) and box.edges == pytest.approx(np.array([[10, 0, 0], [2, 10, 0], [1, -1, 10]]))
    assert box.periodic.tolist() == [True, True, False]
    assert box.nearest(np.array([[11.5, 9.5, 0.0]]))[0] == pytest.approx([-0.5, -0.5, 0])


ONE = [(1, 2, 0, 0, 0, 1)]


@pytest.mark.parametrize("text, arguments, message", [
    (frame(0, [(1, 2, 0, 0, 0)], "id type x y z"), [],
     r"no column radius. Let the script write it,\n  dump see all custom N run.dump id type x y z radius\nor .*--diameter"),
    (frame(0, [(1, 2)], "id type"), [], "has no positions, only id, type. Let the script write them"),
    ("Cu atoms\n1 2 3\n", [], "run.dump: not a text file of dump custom or dump local"),
    (frame(0, ONE)[:-20], [], "run.dump: its only frame is not complete"),
    (frame(0, ONE).replace("0 1\n", "0\n"), [], "rows of step 0 have not the 6 columns"),
    ("", [], "run.dump: it has no frame"),
    (frame(0, ONE), ["--colour", "c_s"], "the dump has no column c_s; it has: id, type"),
    (frame(0, ONE), ["--log", "log.none"], "no log log.none"),
    (frame(0, ONE), ["--bonds"], r"(?s)the log has no dump of bonds.*compute ends all property/local batom1 batom2"),
    (frame(0, ONE), ["--bonds", "b.dump"], "run.dump and b.dump have no step in common"),
    (frame(0, ONE), ["--bonds", "none.dump"], "none.dump: No such file"),
    (frame(5, [(2, 0, 0, 0, 1)], "type x y z radius"), ["--bonds", "b.dump"], "run.dump has no column id"),
    (frame(0, []), [], "run.dump has no particles")])
def test_bad_input_ends_in_one_error_with_a_remedy(folder, text, arguments, message):
    (folder / "run.dump").write_text(text)
    (folder / "b.dump").write_text(bonds_frame(5, [(1, 1, 2, 0.1)]))
    with pytest.raises((look.SeeError, dumps.DumpError), match=message):
        see.main(["run.dump", *arguments])
    assert not (folder / "run.png").exists()


def test_a_frame_that_is_still_being_written_is_left_out(folder, capsys):
    whole = frame(0, [(1, 2, 0, 0, 0, 1), (2, 3, 4, 0, 0, 1)])
    for cut in (5, 40, len(whole) - 1):
        (folder / "run.dump").write_text(whole + whole[:cut])
        see.main(["run.dump"])
        assert "the last frame is not complete, and is left out" in capsys.readouterr().out and (folder / "run.png").exists()
    assert dumps.Dump("run.dump").steps == [0]


def test_files_of_single_frames_are_one_dump(folder):
    for step in (100, 20, 3):
        (folder / f"run.{step}.dump").write_text(frame(step, ONE))
    assert dumps.Dump(*sorted(folder.glob("run.*.dump"))).steps == [3, 20, 100]


def test_the_time_of_a_still_is_chosen(folder):
    (folder / "run.dump").write_text(frame(0, ONE) + frame(10, ONE) + frame(20, ONE))
    (folder / "log.lammps").write_text(log_of())
    seen = see.Seen(see.parse(["run.dump", "--at", "0.012"]))
    assert seen.nearest() == 1 and seen.view().title(seen.frame(1)) == "0.01 s"
    assert see.Seen(see.parse(["run.dump"])).nearest() == 2


# --- the page ---------------------------------------------------------------------------------------------------------

PAGE = (DOCS / "see.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```LAMMPS\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
LINES = [line for kind, block in re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL) if not kind
         for line in block.splitlines()]


@pytest.fixture(scope="module")
def beam(lmp, tmp_path_factory):
    """a folder with the run of the page, with ten frames"""
    folder = tmp_path_factory.mktemp("beam")
    script = BLOCKS[0]
    for name in ("run.dump", "bonds.dump", "contacts.dump"):
        script = replaced(script, f" 200 {name}", f" 2000 {name}")
    run = running.run(replaced(script, "thermo          200", "thermo          2000"), {}, folder, name="mine", log="log.lammps", lmp=lmp)
    assert run.ended_well, run.stdout[-2000:]
    return folder


def test_every_command_of_the_page_works(beam, monkeypatch, capsys):
    monkeypatch.chdir(beam)
    programs = {"tools/see": see.main, "tools/plot": plot.main}
    done = 0
    for line in LINES:
        program, *words = shlex.split(line)
        assert (ROOT / program).exists()
        if "v_stress=stress, Pa" not in words:    # of a script that has these columns
            programs[program](words)
            done += 1
    out = capsys.readouterr().out
    assert done == len(LINES) - 1 == 9
    for file in ("run.png", "run.mp4", "bonds.mp4", "contacts.png", "pieces.png", "speed.png", "run.vtk/run.pvd", "log.lammps.png",
                 "force.png"):
        assert (beam / file).stat().st_size > 500 and file in out


def test_a_broken_beam_is_in_the_files_as_lammps_counted_it(beam):
    """bonds of the thermo output, and the floor 12 spacings of 5 mm below"""
    see.main([str(beam / "run.dump"), "--vtk", str(beam / "all")])
    frames = vtk_files.series(beam / "all" / "run.pvd")
    thermo = logs.read_thermo(beam / "log.lammps")
    assert [time for time, _ in frames] == pytest.approx(thermo["Time"].tolist())
    assert [len(blocks["bonds"].cells("Lines")) for _, blocks in frames] == thermo["Bonds"].astype(int).tolist()
    assert thermo["Bonds"][-1] < thermo["Bonds"][0]
    first = frames[0][1]
    assert first["walls"].points[:, 2] == pytest.approx(-0.06)
    assert first["bonds"].data["c_state[1]"] == pytest.approx(0, abs=1e-12)
    lengths = np.linalg.norm(np.diff(first["bonds"].points.reshape(-1, 2, 3), axis=1)[:, 0], axis=1)
    assert lengths.min() == pytest.approx(0.005) and lengths.max() == pytest.approx(0.01)


def test_lammps_own_picture_is_drawn_in_si_units(run_lammps, tmp_path):
    """as PPM, which needs no library; bonds of the default width would take minutes"""
    script = replaced(BLOCKS[0], "run             20000", "run 2000")
    run_lammps(script[:script.index("# bonds")] + replaced(BLOCKS[1], "*.png", "*.ppm") + "run 2000\n", timeout=60)
    image = np.asarray(Image.open(tmp_path / "picture.002000.ppm"))
    assert image.shape == (600, 900, 3)
    assert 0.02 < np.mean(image.min(axis=2) < 250) < 0.6


def test_the_script_for_paraview_runs(beam, monkeypatch):
    if not shutil.which("xvfb-run") or not shutil.which("pvbatch"):
        pytest.skip("ParaView (pvbatch) and xvfb are not installed; they are no dependency")
    pytest.importorskip("paraview", reason="python3-paraview is not installed; it is no dependency")
    monkeypatch.chdir(beam)
    (code,) = re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    see.main(["run.dump", "--vtk"])
    (beam / "look.py").write_text(replaced(code, "TimestepValues[18]", "TimestepValues[5]"))
    subprocess.run(["xvfb-run", "-a", "-s", "-noreset", "pvbatch", "look.py"], check=True, timeout=120)
    image = np.asarray(Image.open("look.png").convert("RGB")).reshape(-1, 3)
    assert len(np.unique(image, axis=0)) > 200
