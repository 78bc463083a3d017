#pragma once

#include "models/registration/registration_model.h"

#include <QFile>
#include <QObject>

namespace carina
{

/// Logs the progress of the wizard, for later analysis: one JSON object per line at each change.
/// Keys: step, tracker, touched (number of landmarks) and, once known, stylus_rms_um, rms_um of the
/// fit and checked (number of points).
class RegistrationJournal : public QObject
{
    Q_OBJECT

public:
    /// Starts to append to the file. @pre registration outlives this.
    /// @returns FileUnwritable with the path.
    [[nodiscard]] static Result<std::unique_ptr<RegistrationJournal>>
    open(const QString& path, const RegistrationModel& registration);

private:
    explicit RegistrationJournal(const RegistrationModel& registration);
    void writeLine();

    const RegistrationModel& m_registration;
    QFile m_file;
};

} // namespace carina
