#include "apps/registration/registration_journal.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace carina
{
namespace
{

QString stepName(SiteStep step)
{
    switch (step) {
    case SiteStep::Tracker:
        return QStringLiteral("tracker");
    case SiteStep::Stylus:
        return QStringLiteral("stylus");
    case SiteStep::Landmarks:
        return QStringLiteral("landmarks");
    case SiteStep::Touch:
        return QStringLiteral("touch");
    case SiteStep::Fit:
        return QStringLiteral("fit");
    case SiteStep::Verify:
        return QStringLiteral("verify");
    }
    return {};
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
                     {QStringLiteral("touched"), qint64(site.touched.size())}};
    if (site.stylus)
        line[QStringLiteral("stylus_rms_um")] = inMicrometres(site.stylus->rms);
    if (site.registration)
        line[QStringLiteral("rms_um")] = inMicrometres(site.registration->rms);
    m_file.write(QJsonDocument{line}.toJson(QJsonDocument::Compact) + '\n');
    m_file.flush();
}

} // namespace carina
