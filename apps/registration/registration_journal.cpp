#include "apps/registration/registration_journal.h"

#include "engine/io/site/site_json.h"
#include "models/site/site_changes.h"

#include <QJsonDocument>

namespace carina
{
namespace
{

QString stepName(SiteStep step)
{
    return QString::fromLatin1(kStepWords[static_cast<std::size_t>(step)]);
}

int inMicrometres(double length) { return qRound(1e6 * length); }

} // namespace

RegistrationJournal::RegistrationJournal(const RegistrationModel& registration)
    : m_registration{registration}
{
    connect(&m_registration, &RegistrationModel::changed, this, &RegistrationJournal::writeLine);
}

Result<std::unique_ptr<RegistrationJournal>>
RegistrationJournal::open(const QString& path, const RegistrationModel& registration)
{
    std::unique_ptr<RegistrationJournal> journal{new RegistrationJournal{registration}};
    journal->m_file.setFileName(path);
    if (!journal->m_file.open(QIODevice::WriteOnly | QIODevice::Append))
        return fail(Errc::FileUnwritable, path.toStdString());
    journal->writeLine();
    return journal;
}

void RegistrationJournal::writeLine()
{
    const Site& site = m_registration.site();
    QJsonObject line{{QStringLiteral("step"), stepName(site.step)},
                     {QStringLiteral("tracker"), QString::fromStdString(site.tracker)},
                     {QStringLiteral("touched"), qint64(freshTouches(site).size())}};
    if (!site.styluses.empty())
        line[QStringLiteral("stylus_rms_um")] = inMicrometres(site.styluses.front().rms);
    if (site.registration)
        line[QStringLiteral("rms_um")] = inMicrometres(site.registration->rms);
    if (site.verification)
        line[QStringLiteral("checked")] = qint64(site.verification->points.size());
    m_file.write(QJsonDocument{line}.toJson(QJsonDocument::Compact) + '\n');
    m_file.flush();
}

} // namespace carina
