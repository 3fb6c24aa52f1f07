# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Makes of any dump of particles a still, a film or files for ParaView and OVITO (docs/see.md)."""

import argparse
import functools
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

from potdem import commands, dumps, logs, look, paraview, picture
from potdem.look import Links, SeeError, View
from potdem.progress import Progress

SAMPLES = 12    # frames that decide what is seen, and the range of colours


# --- files ------------------------------------------------------------------------------------------------------------

def film(view, frames, count, path):
    """an mp4, frame by frame through ffmpeg"""
    program = shutil.which("ffmpeg")
    if not program:
        raise SeeError("ffmpeg, which makes films, is not installed: apt-get install ffmpeg")
    figure, axis = view.figure()
    wide, high = (size - size % 2 for size in figure.canvas.get_width_height())    # the codec wants even numbers
    progress = Progress(f"{path}: {count} frames")
    progress.total = count
    arguments = [program, "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{wide}x{high}",
                 "-r", str(picture.FRAMES_PER_SECOND), "-i", "-", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18",
                 "-movflags", "+faststart", str(path)]
    with subprocess.Popen(arguments, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            for number, frame in enumerate(frames, start=1):
                view.show(axis, frame)
                figure.canvas.draw()
                process.stdin.write(np.ascontiguousarray(np.asarray(figure.canvas.buffer_rgba())[:high, :wide, :3]).tobytes())
                progress.step = number
                progress.show()
            process.stdin.close()
        except BrokenPipeError:
            pass    # what ffmpeg says follows
        said = process.stderr.read().decode(errors="replace").strip()
    if process.returncode != 0:
        raise SeeError(f"ffmpeg made no film of {path}: {said}")
    progress.end()
    picture.plt.close(figure)


def still(view, frame, path):
    figure, axis = view.figure()
    view.show(axis, frame)
    figure.savefig(path, dpi=look.DPI, facecolor="white")
    picture.plt.close(figure)


def vtk(view, every, frames, count, folder, name):
    """files for ParaView, with all links that there are"""
    series = paraview.Series(folder, name)
    progress = Progress(f"{series.path}: {count} frames")
    progress.total = count
    for number, frame in enumerate(frames, start=1):
        blocks = {"particles": paraview.particles(frame)}
        for links in every:
            if frame.step in links.number:
                blocks[links.kind] = paraview.lines(*links.at(frame))
        tiles = view.tiles(frame.step)
        if tiles is not None:
            blocks["walls"] = paraview.walls(tiles.corners)
        time = view.time(frame)
        series.add(frame.step if time is None else time, blocks)
        progress.step = number
        progress.show()
    progress.end()
    return series.end()


# --- the command ------------------------------------------------------------------------------------------------------

def parse(argv):
    parser = argparse.ArgumentParser(prog="tools/see", description="A still, a film or files for ParaView and OVITO of a dump "
                                     "(dump custom), with what the log beside it says of units, time and walls.")
    parser.add_argument("dump", nargs="+", help="file of dump custom; several, if the script writes one for each frame")
    parser.add_argument("--still", nargs="?", const="", metavar="FILE.png", help="a picture, of the last frame (the default)")
    parser.add_argument("--film", nargs="?", const="", metavar="FILE.mp4", help="a film of all frames")
    parser.add_argument("--vtk", nargs="?", const="", metavar="FOLDER", help="files for ParaView and OVITO")
    parser.add_argument("--bonds", nargs="?", const="", metavar="FILE", help="draw bonds, from this dump local or the one in the log")
    parser.add_argument("--contacts", nargs="?", const="", metavar="FILE", help="draw contacts, likewise")
    parser.add_argument("--colour", "--color", metavar="COLUMN", help="what gives the colours: a column, or speed")
    parser.add_argument("--range", nargs=2, type=float, metavar=("LOW", "HIGH"), help="values at the ends of the colours")
    parser.add_argument("--at", type=float, metavar="TIME", help="of the still, instead of the last frame")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="take every Nth frame")
    parser.add_argument("--view", nargs=2, type=float, metavar=("TURN", "TILT"),
                        help="direction, degrees: 0 0 is from the front, 0 90 from above")
    parser.add_argument("--diameter", type=float, metavar="D", help="of all particles, where the dump has none")
    parser.add_argument("--log", metavar="FILE", help="log of the run (default: one beside the dump that names it)")
    arguments = parser.parse_args(argv)
    if arguments.bonds is not None and arguments.contacts is not None and arguments.vtk is None:
        parser.error("--bonds or --contacts: a picture shows one of the two")
    if arguments.every < 1:
        parser.error("--every must be at least 1")
    return arguments


def say(text):
    print(text, flush=True)


class Seen:
    """what the command line names, read"""

    def __init__(self, arguments):
        self.arguments = arguments
        self.dump = dumps.Dump(*arguments.dump)
        self.source = Path(arguments.dump[0])
        if self.dump.cut:
            say(f"{self.dump.cut}: the last frame is not complete, and is left out (the run goes on, or was stopped)")
        if arguments.log and not Path(arguments.log).exists():
            raise SeeError(f"no log {arguments.log}")
        self.run = commands.of_log(arguments.log) if arguments.log else commands.beside(arguments.dump)
        if self.run is None:
            say("no log beside the dump names it: no walls, no time in seconds (--log FILE)")
            self.run = commands.Commands()
        self.run.units = self.dump.units or self.run.units
        self.links = [links for kind in look.KINDS if (links := self._links(kind))]
        wanted = [links for links in self.links if getattr(arguments, links.kind) is not None]
        self.drawn = wanted[0] if wanted else None
        self.numbers = self._numbers()

    def _links(self, kind):
        """those that are asked for; all that the log knows of for files for ParaView"""
        given = getattr(self.arguments, kind)
        if given:
            return Links(kind, given, self.run)
        if given is None and self.arguments.vtk is None:
            return None
        for words in self.run.dumps:
            if words[0] == "dump" and words[3] == "local" and any(self.run.meaning(word)[1] == look.KINDS[kind][0] for word in words[6:]):
                file = self.source.parent / Path(words[5]).name
                if file.exists():
                    return Links(kind, file, self.run)
        if given is None:
            return None
        raise SeeError(f"the log has no dump of {kind}: name its file after --{kind}. To have one, put into the script:\n"
                       f"{Links.advice(kind, f'{kind}.dump')}")

    def _numbers(self):
        """of the frames to show: those that have the links too"""
        numbers = range(0, len(self.dump), self.arguments.every)
        if self.drawn:
            if "id" not in self.dump.names:
                raise SeeError(f"{self.source} has no column id, by which {self.drawn.kind} find their particles")
            numbers = [number for number in numbers if self.dump.steps[number] in self.drawn.number]
            if not numbers:
                raise SeeError(f"{self.source} and {self.drawn.path} have no step in common: give both dumps the same N")
        return list(numbers)

    def frame(self, number):
        return look.placed(self.dump[number], self.source, self.arguments.diameter)

    def frames(self):
        return (self.frame(number) for number in self.numbers)

    @functools.cached_property
    def thermo(self):
        """of the log, or None: one that cannot be read is no reason to show nothing"""
        try:
            return logs.read_thermo(self.run.path, last=True) if self.run.path else None
        except logs.LogError as problem:
            say(f"{problem}; times are steps of the timestep command")
            return None

    def view(self):
        """how all frames are shown: a still has the window and the colours of the film"""
        numbers = self.numbers
        chosen = sorted({numbers[round(k)] for k in np.linspace(0, len(numbers) - 1, min(SAMPLES, len(numbers)))})
        samples = [frame for number in chosen if (frame := self.frame(number))["x"].size]
        if not samples:
            raise SeeError(f"{self.source} has no particles")
        direction = tuple(self.arguments.view or look.direction_of(samples))
        colours = look.colouring(samples, self.run, self.drawn, self.arguments.colour, self.arguments.range)
        view = View("", None, colours.scale, (), (), direction, run=self.run, colouring=colours, links=self.drawn,
                    room=look.room_of(samples), thermo=self.thermo)
        view.draw = view.paint
        view.window, view.bar = look.window_of(samples, direction, view.tiles(samples[-1].step))
        if self.run.units != "si":
            view.bar_words = f"{view.bar[0]:g} {self.run.unit('length')}".strip()
        return view

    def nearest(self):
        """number of the frame for a still"""
        if self.arguments.at is None:
            return self.numbers[-1]
        view = View("", None, None, (), (), run=self.run, thermo=self.thermo)
        times = []
        for number in self.numbers:
            place = self.dump.places[number]
            time = view.time(dumps.Frame(place.step, {} if place.time is None else {"time": place.time}))
            times.append(place.step if time is None else time)
        return self.numbers[int(np.argmin(np.abs(np.array(times) - self.arguments.at)))]


def main(argv):
    arguments = parse(argv)
    seen = Seen(arguments)
    stem = seen.source.name.removesuffix(".dump")

    def beside(ending):
        return seen.source.with_name(stem + ending)

    done = [arguments.film, arguments.vtk, arguments.still]
    view = None
    if arguments.film is not None:
        view, path = seen.view(), Path(arguments.film or beside(".mp4"))
        film(view, seen.frames(), len(seen.numbers), path)
        say(f"film:    {path}")
    if arguments.vtk is not None:
        view = view or seen.view()
        folder = Path(arguments.vtk or beside(".vtk"))
        say(f"frames:  {vtk(view, seen.links, seen.frames(), len(seen.numbers), folder, stem)}")
    if arguments.still is not None or all(what is None for what in done):
        number = seen.nearest()
        view, path = view or seen.view(), Path(arguments.still or beside(".png"))
        still(view, seen.frame(number), path)
        say(f"picture: {path}")
    for note in sorted(view.not_drawn):
        say(note)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (SeeError, dumps.DumpError, logs.LogError) as problem:
        sys.exit(f"tools/see: {problem}")
