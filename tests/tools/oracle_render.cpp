// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "oracle_render.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace witness
{

namespace
{

namespace fs = std::filesystem;

std::string Sdl(const Vector& v)
{
    std::ostringstream out;
    out << std::setprecision(17) << '<' << v.x << ", " << v.y << ", " << v.z << '>';
    return out.str();
}

struct Range
{
    int first, last;
};

std::string FrameName(int frame, int frames)
{
    const std::string number = std::to_string(frame), widest = std::to_string(frames);
    return "frame" + std::string(widest.size() - number.size(), '0') + number + ".png";
}

pid_t Start(const std::vector<std::string>& arguments, const fs::path& log)
{
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t pid = 0;
    const int failure = posix_spawnp(&pid, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throw std::runtime_error("cannot start " + arguments[0] + ": " + std::strerror(failure));
    return pid;
}

bool Finished(pid_t pid)
{
    int status = 0;
    while (waitpid(pid, &status, 0) < 0)
        if (errno != EINTR)
            return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// POV-Ray may always write in its working folder, so frames are rendered there.
class WorkingFolder
{
  public:
    explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~WorkingFolder()
    {
        std::error_code ignored;
        fs::current_path(before_, ignored);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

  private:
    fs::path before_;
};

void RunAll(const OracleCase& description, const RenderSettings& settings, const std::vector<Range>& ranges, int frames)
{
    const WorkingFolder here(settings.work);
    std::vector<pid_t> running;
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
        const std::string part = "part" + std::to_string(i);
        running.push_back(Start({settings.povray, "+I" + part + ".pov", "+Oframe.png", "+FN16", "File_Gamma=1.0",
                                 "+W" + std::to_string(description.width), "+H" + std::to_string(description.height), "+KFI1",
                                 "+KFF" + std::to_string(frames), "+SF" + std::to_string(ranges[i].first),
                                 "+EF" + std::to_string(ranges[i].last), "-A", "-D", "-V", "-GA", "-P", "+WT1"},
                                part + ".log"));
    }
    std::string failed;
    for (std::size_t i = 0; i < running.size(); ++i)
        if (!Finished(running[i]))
            failed += " part" + std::to_string(i) + ".log";
    if (!failed.empty())
        throw std::runtime_error(settings.povray + " failed; see in " + settings.work.string() + ":" + failed);
}

Picture Mean(const RenderSettings& settings, const OracleCase& description, Range range, int frames)
{
    Picture sum;
    for (int frame = range.first; frame <= range.last; ++frame)
    {
        const fs::path path = settings.work / FrameName(frame, frames);
        const Picture picture = ReadPicture(path.string());
        if (picture.width != description.width || picture.height != description.height)
            throw std::runtime_error(path.string() + " has the wrong size");
        if (sum.values.empty())
            sum = picture;
        else
            std::transform(sum.values.begin(), sum.values.end(), picture.values.begin(), sum.values.begin(),
                           [](double a, double b) { return a + b; });
        fs::remove(path);
    }
    for (double& value : sum.values)
        value /= range.last - range.first + 1;
    return sum;
}

} // namespace

std::string AnimationScene(const OracleCase& description, const CameraSolved& camera, const std::vector<LensPoint>& points, int first)
{
    std::ostringstream out;
    out << std::setprecision(17) << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n"
        << "#declare Location = " << Sdl(camera.location) << ";\n"
        << "#declare Direction = " << Sdl(camera.direction) << ";\n"
        << "#declare Right = " << Sdl(camera.right) << ";\n#declare Up = " << Sdl(camera.up) << ";\n"
        << "#declare Focus = " << Sdl(camera.focus) << ";  // plane of sharp focus: Focus.(X - Location) = 1\n"
        << "#declare Points = array[" << points.size() << "][4] {  // pixel x, y; lens a, b\n";
    for (const LensPoint& point : points)
        out << "{" << point.jitterX << "," << point.jitterY << "," << point.a << "," << point.b << "},\n";
    out << "}\n#declare I = frame_number - " << first << ";\n"
        << "#declare L = Points[I][2]*" << Sdl(camera.lensX) << " + Points[I][3]*" << Sdl(camera.lensY) << ";\n"
        << "#declare Middle = Direction + Points[I][0]/" << description.width << "*Right + Points[I][1]/" << description.height << "*Up;\n"
        << "camera { perspective location Location + L direction Middle - vdot(Focus, Middle)*L\n"
        << "  right Right - vdot(Focus, Right)*L up Up - vdot(Focus, Up)*L }\n"
        << "#include \"" << description.scene << "\"\n";
    return out.str();
}

Reference RenderOracle(const OracleCase& description, const RenderSettings& settings)
{
    const double aspect = static_cast<double>(description.width) / description.height;
    const CameraSolved camera = SolveCase(description.camera, aspect);
    const int frames = settings.batches * settings.samples;
    std::vector<LensPoint> points;
    for (int batch = 0; batch < settings.batches; ++batch)
    {
        const std::vector<LensPoint> more = LensPoints(settings.samples, settings.seed + batch, description.camera.blades,
                                                       description.camera.bladesAngle);
        points.insert(points.end(), more.begin(), more.end());
    }

    fs::create_directories(settings.work);
    fs::copy_file(settings.scenes / description.scene, settings.work / description.scene, fs::copy_options::overwrite_existing);
    std::vector<Range> ranges;
    const int parts = std::min(settings.processes, frames);
    for (int part = 0; part < parts; ++part)
    {
        const Range range{frames * part / parts + 1, frames * (part + 1) / parts};
        const std::vector<LensPoint> own(points.begin() + range.first - 1, points.begin() + range.last);
        std::ofstream scene(settings.work / ("part" + std::to_string(part) + ".pov"));
        scene << AnimationScene(description, camera, own, range.first);
        if (!scene.flush())
            throw std::runtime_error("cannot write scenes to " + settings.work.string());
        ranges.push_back(range);
    }
    RunAll(description, settings, ranges, frames);

    std::vector<Picture> batches;
    for (int batch = 0; batch < settings.batches; ++batch)
        batches.push_back(Mean(settings, description, {batch * settings.samples + 1, (batch + 1) * settings.samples}, frames));
    return Average(batches);
}

} // namespace witness
