#include "apps/lab/registration/plus_config.h"

#include "engine/core/units.h"
#include "engine/io/files/file_limit.h"

#include <QFile>
#include <QXmlStreamReader>

#include <cmath>
#include <optional>

namespace carina::lab
{
namespace
{

/// Numbers parted by blanks, exactly that many and finite.
std::optional<std::vector<double>> plusNumbers(QStringView text, std::size_t count)
{
    std::vector<double> numbers;
    const QString simple = text.toString().simplified();
    for (const QString& word : simple.split(QLatin1Char{' '}, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        numbers.push_back(word.toDouble(&isNumber));
        if (!isNumber || !std::isfinite(numbers.back()))
            return std::nullopt;
    }
    if (numbers.size() != count)
        return std::nullopt;
    return numbers;
}

/// The translation of a matrix of 16 numbers row by row.
std::optional<Vec3> tipOf(const QXmlStreamAttributes& attributes)
{
    const auto numbers = plusNumbers(attributes.value(QLatin1String{"Matrix"}), 16);
    if (!numbers)
        return std::nullopt;
    return millimetres(1.0).si * Vec3{(*numbers)[3], (*numbers)[7], (*numbers)[11]};
}

std::optional<Landmark> landmarkOf(const QXmlStreamAttributes& attributes)
{
    const auto numbers = plusNumbers(attributes.value(QLatin1String{"Position"}), 3);
    if (!numbers)
        return std::nullopt;
    return Landmark{attributes.value(QLatin1String{"Name"}).toString().toStdString(),
                    millimetres(1.0).si * Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]}};
}

} // namespace

Result<PlusConfig> readPlusConfig(const QString& file)
{
    const std::string name = file.toStdString();
    QFile source{file};
    if (!source.open(QIODevice::ReadOnly))
        return fail(Errc::FileNotFound, name + " cannot be opened.");
    if (const auto good = checkSize(name, std::uint64_t(source.size()), kDescriptionLimit); !good)
        return tl::unexpected(good.error());
    QXmlStreamReader xml{&source};
    PlusConfig config;
    bool hasTip = false;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QXmlStreamAttributes attributes = xml.attributes();
        if (xml.name() == QLatin1String{"Transform"}
            && attributes.value(QLatin1String{"From"}) == QLatin1String{"StylusTip"}
            && attributes.value(QLatin1String{"To"}) == QLatin1String{"Stylus"}) {
            const auto p_SQ = tipOf(attributes);
            hasTip = p_SQ.has_value();
            if (hasTip)
                config.p_SQ = *p_SQ;
        } else if (xml.name() == QLatin1String{"Landmark"}) {
            const auto landmark = landmarkOf(attributes);
            if (!landmark)
                return fail(Errc::FileMalformed, name + " line " + std::to_string(xml.lineNumber())
                                                     + ": a landmark's Position has not three "
                                                       "numbers.");
            config.landmarks.push_back(*landmark);
        }
    }
    if (xml.hasError())
        return fail(Errc::FileMalformed, name + " line " + std::to_string(xml.lineNumber()) + ": "
                                             + xml.errorString().toStdString());
    if (!hasTip)
        return fail(Errc::FileMalformed,
                    name + " has no transform of 16 numbers from StylusTip to Stylus.");
    if (config.landmarks.empty())
        return fail(Errc::FileMalformed, name + " has no landmark.");
    return config;
}

} // namespace carina::lab
