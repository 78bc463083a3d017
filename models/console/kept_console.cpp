#include "models/console/kept_console.h"

#include <QDir>
#include <QSettings>
#include <QVariantList>

#include <optional>

namespace carina
{
namespace
{

const QString kPanels = QStringLiteral("panels");
const QString kAirwayGroup = QStringLiteral("airwayGroup");
const QString kViews = QStringLiteral("views");

QVariantList numbers(const SavedView& view)
{
    QVariantList all;
    for (const Vec3& vector : {view.p_A_eye, view.p_A_target, view.up_A})
        for (const double value : vector)
            all << value;
    return all;
}

/// Nothing where a hand has written something else.
std::optional<SavedView> viewOf(const QString& name, const QVariantList& numbers)
{
    if (name.isEmpty() || numbers.size() != 9)
        return std::nullopt;
    SavedView view{.name = name};
    int next = 0;
    for (Vec3* vector : {&view.p_A_eye, &view.p_A_target, &view.up_A})
        for (double& value : *vector)
            value = numbers[next++].toDouble();
    return isPossible(view) ? std::optional{view} : std::nullopt;
}

} // namespace

KeptConsole::KeptConsole(const QString& folder)
    : m_file{folder.isEmpty() ? QString{} : QDir{folder}.filePath(QStringLiteral("console.ini"))}
{
}

QByteArray KeptConsole::bytes(const QString& key) const
{
    return m_file.isEmpty() ? QByteArray{}
                            : QSettings{m_file, QSettings::IniFormat}.value(key).toByteArray();
}

void KeptConsole::keep(const QString& key, const QByteArray& value)
{
    if (!m_file.isEmpty())
        QSettings{m_file, QSettings::IniFormat}.setValue(key, value);
}

QByteArray KeptConsole::panels() const { return bytes(kPanels); }

void KeptConsole::keepPanels(const QByteArray& panels) { keep(kPanels, panels); }

QByteArray KeptConsole::airwayGroup() const { return bytes(kAirwayGroup); }

void KeptConsole::keepAirwayGroup(const QByteArray& name) { keep(kAirwayGroup, name); }

std::vector<SavedView> KeptConsole::views() const
{
    std::vector<SavedView> views;
    if (m_file.isEmpty())
        return views;
    QSettings settings{m_file, QSettings::IniFormat};
    const int count = settings.beginReadArray(kViews);
    for (int place = 0; place < count && views.size() < SavedViews::kMost; ++place) {
        settings.setArrayIndex(place);
        if (auto view = viewOf(settings.value(QStringLiteral("name")).toString(),
                               settings.value(QStringLiteral("from")).toList()))
            views.push_back(*std::move(view));
    }
    return views;
}

void KeptConsole::keepViews(const std::vector<SavedView>& views)
{
    if (m_file.isEmpty())
        return;
    QSettings settings{m_file, QSettings::IniFormat};
    settings.remove(kViews);
    settings.beginWriteArray(kViews, int(views.size()));
    for (std::size_t place = 0; place < views.size(); ++place) {
        settings.setArrayIndex(int(place));
        settings.setValue(QStringLiteral("name"), views[place].name);
        settings.setValue(QStringLiteral("from"), numbers(views[place]));
    }
}

} // namespace carina
