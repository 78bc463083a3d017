#pragma once

#include "models/tracker/tracker_form.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace carina
{

class CheckedDoubleSpinBox;

/// The fields for the simulated tracker: its rate, how many exposures are not delivered, whether
/// there is a laryngoscope, and which tools are hidden for a part of the time, wholly or by half;
/// and the option of a start that chooses the same.
class SimulatedFields : public QWidget
{
    Q_OBJECT

public:
    explicit SimulatedFields(QWidget* parent = nullptr);

    void fill(const TrackerForm& form);
    /// Puts what is in the fields into a form.
    void read(TrackerForm& form) const;
    /// Takes a number that is typed and not entered yet.
    void enterTyped();

Q_SIGNALS:
    void changed();

private:
    enum class Sight : std::uint8_t { Always, Hidden, Partly };

    void layOut();
    [[nodiscard]] QWidget* toolFields();
    void edited();

    CheckedDoubleSpinBox* m_rate;
    CheckedDoubleSpinBox* m_dropouts;
    QCheckBox* m_laryngoscope;
    std::vector<QComboBox*> m_sights; ///< of simulatedRoles()
    QLabel* m_words;
};

} // namespace carina
