#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "models/patient/patient_source.h"

#include <QObject>
#include <QThreadPool>

#include <optional>

namespace carina
{

/// A patient who may be laid in a session, and how they breathe at rest.
struct ReadyPatient {
    SharedPatientModel model;
    PatientDimensions dimensions;
};

/// The patient of a session that is being planned, made on another thread as soon as it is named,
/// so that it can be looked at before and is there at once when the session begins.
class PlannedPatient : public QObject
{
    Q_OBJECT

public:
    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    explicit PlannedPatient(std::filesystem::path cacheFolder);
    ~PlannedPatient() override;

    /// Makes the built-in patient of these words (patientFromWords) from now on. Words that name
    /// nobody leave none.
    void want(const QString& words);
    /// Leaves none, until another is wanted or taken.
    void drop();
    /// Takes one that was imported.
    void take(const ReadyPatient& patient);

    /// Nothing while one is made, and where that failed.
    [[nodiscard]] const std::optional<ReadyPatient>& patient() const { return m_patient; }
    [[nodiscard]] bool isBeingMade() const { return m_isBeingMade; }
    /// Why there is none; empty where there is one or is going to be.
    [[nodiscard]] const QString& fault() const { return m_fault; }

Q_SIGNALS:
    void changed();

private:
    void made(const QString& words, const Result<ReadyPatient>& patient);

    std::filesystem::path m_cacheFolder;
    QString m_words;
    std::optional<ReadyPatient> m_patient;
    bool m_isBeingMade = false;
    QString m_fault;
    QThreadPool m_maker;
};

} // namespace carina
