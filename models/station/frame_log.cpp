#include "models/station/frame_log.h"

#include "engine/io/files/file_limit.h"

#include <QFile>
#include <QSaveFile>
#include <QStringList>

namespace carina
{
namespace
{

constexpr int kColumns = 22;

QByteArray header()
{
    return "local_ns,session_ns,level,amplitude_right,amplitude_left,tube_x_m,tube_y_m,tube_z_m,"
           "tube_qx,tube_qy,tube_qz,tube_qw,sample_age_ns,volume_right_ml,volume_left_ml,"
           "patient_x_m,patient_y_m,patient_z_m,patient_qx,patient_qy,patient_qz,patient_qw\n";
}

QByteArray exact(double value) { return QByteArray::number(value, 'g', 17); }

/// Place and rotation, or as many empty cells.
QByteArrayList poseCells(const std::optional<RigidTransform>& X_AF)
{
    if (!X_AF)
        return QByteArrayList(7);
    const Vec3& p = X_AF->translation();
    const Quat& q = X_AF->rotation();
    QByteArrayList cells;
    for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()})
        cells << exact(value);
    return cells;
}

QByteArray line(const LoggedFrame& f)
{
    QByteArrayList cells{QByteArray::number(qlonglong(f.local.time_since_epoch().count())),
                         QByteArray::number(qlonglong(f.session.time_since_epoch().count())),
                         QByteArray::number(f.level),
                         QByteArray::number(double{f.amplitude[0]}, 'g', 9),
                         QByteArray::number(double{f.amplitude[1]}, 'g', 9)};
    cells << poseCells(f.X_AE);
    cells << (f.sampleAge ? QByteArray::number(qlonglong(f.sampleAge->count())) : QByteArray{});
    cells << exact(f.volume_ml[0]) << exact(f.volume_ml[1]) << poseCells(f.X_AV);
    return cells.join(',') + '\n';
}

/// The numbers of one line; nothing where one is missing that must be there.
std::optional<LoggedFrame> parse(const QByteArrayList& cells)
{
    if (cells.size() != kColumns)
        return std::nullopt;
    bool allRight = true;
    const auto whole = [&](int i) {
        bool right = false;
        const qlonglong value = cells[i].toLongLong(&right);
        allRight = allRight && right;
        return value;
    };
    const auto real = [&](int i) {
        bool right = false;
        const double value = cells[i].toDouble(&right);
        allRight = allRight && right;
        return value;
    };
    LoggedFrame f;
    f.local = LocalTime{Duration{whole(0)}};
    f.session = SessionTime{Duration{whole(1)}};
    f.level = static_cast<int>(whole(2));
    f.amplitude = {static_cast<float>(real(3)), static_cast<float>(real(4))};
    const auto pose = [&](int i, std::optional<RigidTransform>& X_AF) {
        if (cells[i].isEmpty())
            return;
        const Quat q{real(i + 6), real(i + 3), real(i + 4), real(i + 5)};
        allRight = allRight && q.coeffs().allFinite() && q.norm() >= 0.5;
        if (allRight)
            X_AF = RigidTransform{q, Vec3{real(i), real(i + 1), real(i + 2)}};
    };
    pose(5, f.X_AE);
    pose(15, f.X_AV);
    if (!cells[12].isEmpty())
        f.sampleAge = Duration{whole(12)};
    f.volume_ml = {real(13), real(14)};
    return allRight ? std::optional{f} : std::nullopt;
}

} // namespace

Result<void> writeFrames(const QString& path, const std::vector<LoggedFrame>& frames)
{
    QSaveFile file{path};
    if (!file.open(QIODevice::WriteOnly))
        return fail(Errc::FileUnwritable, path.toStdString());
    file.write(header());
    for (const LoggedFrame& frame : frames)
        file.write(line(frame));
    if (!file.commit())
        return fail(Errc::FileUnwritable, path.toStdString());
    return {};
}

Result<std::vector<LoggedFrame>> readFrames(const QString& path)
{
    if (const auto good = readableSize(path.toStdString(), kMeasurementLimit); !good)
        return tl::unexpected(good.error());
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly))
        return fail(Errc::FileNotFound, path.toStdString());
    std::vector<LoggedFrame> frames;
    int number = 1;
    if (file.readLine() != header())
        return fail(Errc::FileMalformed, path.toStdString() + ": line 1 is not the header");
    while (!file.atEnd()) {
        ++number;
        const std::optional<LoggedFrame> frame = parse(file.readLine().trimmed().split(','));
        if (!frame)
            return fail(Errc::FileMalformed, path.toStdString() + ": line " + std::to_string(number)
                                                 + " is not a frame");
        frames.push_back(*frame);
    }
    return frames;
}

} // namespace carina
