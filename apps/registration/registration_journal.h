#pragma once

#include "models/registration/registration_model.h"

#include <QFile>
#include <QObject>

namespace carina
{

/// What the wizard shows, as one JSON object a line whenever it changes, for whoever has to
/// understand later how far a registration had come. Keys: step, tracker, touched (how many
/// landmarks), and, once they are known, stylus_rms_um, rms_um of the fit and checked (how many
/// places).
class RegistrationJournal : public QObject
{
    Q_OBJECT

public:
    /// Appends to the file from now on. @pre registration outlives this.
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
