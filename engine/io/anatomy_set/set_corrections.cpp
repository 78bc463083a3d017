#include "engine/io/anatomy_set/set_corrections.h"

#include "engine/io/files/json_fields.h"

#include <QCryptographicHash>
#include <QJsonDocument>

#include <array>
#include <cmath>

namespace carina
{
namespace
{

const QString kCorrectionsSchema = QStringLiteral("carina.set-corrections/1");
constexpr const char* kLeftOut = "left_out";
constexpr double kSmallestUnit = 1e-6; ///< metres
constexpr double kLargestUnit = 1e3;   ///< metres

Error faultIn(const std::string& what) { return {Errc::FileMalformed, what}; }

QJsonObject jsonOf(const SetCorrections& corrections)
{
    QJsonObject roles;
    for (const auto& [key, role] : corrections.roles)
        roles.insert(QString::fromStdString(key),
                     QString::fromLatin1(role ? roleName(*role) : kLeftOut));
    QJsonObject object{{QStringLiteral("schema"), kCorrectionsSchema},
                       {QStringLiteral("roles"), roles}};
    if (corrections.frame) {
        QJsonArray axes;
        for (const std::string& word : axisWords(*corrections.frame))
            axes.append(QString::fromStdString(word));
        object.insert(QStringLiteral("unit_mm"), 1e3 * corrections.frame->metresPerUnit);
        object.insert(QStringLiteral("axes"), axes);
    }
    return object;
}

Result<SetFrame> frameIn(const QJsonObject& object)
{
    SetFrame frame;
    frame.metresPerUnit = 1e-3 * object[QStringLiteral("unit_mm")].toDouble();
    if (frame.metresPerUnit < kSmallestUnit || frame.metresPerUnit > kLargestUnit)
        return tl::unexpected(faultIn("unit_mm: millimetres of one unit are expected"));
    std::vector<std::string> words;
    for (const QJsonValue& word : object[QStringLiteral("axes")].toArray())
        words.push_back(word.toString().toStdString());
    const auto axes = axesFromWords(words);
    if (!axes)
        return tl::unexpected(faultIn("axes: where +x, +y and +z point is expected"));
    frame.R_AF = *axes;
    return frame;
}

Result<SetCorrections> correctionsIn(const QJsonObject& object)
{
    SetCorrections corrections;
    const QJsonObject roles = object[QStringLiteral("roles")].toObject();
    for (auto it = roles.begin(); it != roles.end(); ++it) {
        const std::string word = it.value().toString().toStdString();
        const std::optional<PartRole> role = roleFromName(word);
        if (!role && word != kLeftOut)
            return tl::unexpected(faultIn("roles: no part is a \"" + word + "\""));
        corrections.roles[it.key().toStdString()] = role;
    }
    if (object.contains(QStringLiteral("unit_mm")) || object.contains(QStringLiteral("axes"))) {
        const auto frame = frameIn(object);
        if (!frame)
            return tl::unexpected(frame.error());
        corrections.frame = *frame;
    }
    return corrections;
}

} // namespace

std::optional<Mat3> axesFromWords(const std::vector<std::string>& words)
{
    constexpr std::array kAlong{"left", "posterior", "superior"};
    constexpr std::array kAgainst{"right", "anterior", "inferior"};
    if (words.size() != 3)
        return std::nullopt;
    Mat3 R_AF = Mat3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        for (int direction = 0; direction < 3; ++direction) {
            const auto place = static_cast<std::size_t>(direction);
            const std::string& word = words[static_cast<std::size_t>(axis)];
            if (word == kAlong[place])
                R_AF(direction, axis) = 1.0;
            if (word == kAgainst[place])
                R_AF(direction, axis) = -1.0;
        }
    return std::abs(R_AF.determinant()) == 1.0 ? std::optional{R_AF} : std::nullopt;
}

std::string correctedHash(const std::string& contentHashOfFiles, const SetCorrections& corrections)
{
    if (corrections.empty())
        return contentHashOfFiles;
    QCryptographicHash hash{QCryptographicHash::Sha256};
    hash.addData(QByteArray::fromStdString(contentHashOfFiles));
    hash.addData(QJsonDocument{jsonOf(corrections)}.toJson(QJsonDocument::Compact));
    return hash.result().toHex().toStdString();
}

Result<void> writeCorrections(const std::filesystem::path& file, const SetCorrections& corrections)
{
    return writeJsonFile(file, jsonOf(corrections));
}

Result<SetCorrections> readCorrections(const std::filesystem::path& file)
{
    const Result<QJsonObject> object = readJsonFile(file, kCorrectionsSchema);
    if (!object)
        return tl::unexpected(object.error());
    auto corrections = correctionsIn(*object);
    if (!corrections)
        return fail(corrections.error().code, file.string() + ": " + corrections.error().detail);
    return corrections;
}

} // namespace carina
