#include "models/frame_log.h"

#include <QFile>
#include <QSaveFile>
#include <QStringList>

namespace carina
{
namespace
{

constexpr int kColumns = 15;

QByteArray header()
{
    return "local_ns,session_ns,level,amplitude_right,amplitude_left,tube_x_m,tube_y_m,tube_z_m,"
           "tube_qx,tube_qy,tube_qz,tube_qw,sample_age_ns,volume_right_ml,volume_left_ml\n";
}

QByteArray exact(double value) { return QByteArray::number(value, 'g', 17); }

QByteArray line(const LoggedFrame& f)
{
    QByteArrayList cells{QByteArray::number(qlonglong(f.local.time_since_epoch().count())),
                         QByteArray::number(qlonglong(f.session.time_since_epoch().count())),
                         QByteArray::number(f.level),
                         QByteArray::number(double{f.amplitude[0]}, 'g', 9),
                         QByteArray::number(double{f.amplitude[1]}, 'g', 9)};
    if (f.X_AE) {
        const Vec3& p = f.X_AE->translation();
        const Quat& q = f.X_AE->rotation();
        for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()})
            cells << exact(value);
    } else {
        cells << QByteArrayList(7);
    }
    cells << (f.sampleAge ? QByteArray::number(qlonglong(f.sampleAge->count())) : QByteArray{});
    cells << exact(f.volume_ml[0]) << exact(f.volume_ml[1]);
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
    if (!cells[5].isEmpty()) {
        const Quat q{real(11), real(8), real(9), real(10)};
        if (!allRight || !q.coeffs().allFinite() || q.norm() < 0.5)
            return std::nullopt;
        f.X_AE = RigidTransform{q, Vec3{real(5), real(6), real(7)}};
    }
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
