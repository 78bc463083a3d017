#pragma once

#include "models/airway/head_position_model.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace carina
{

/// Shows and sets how head and neck of the patient lie: a choice of the usual positions, which says
/// "Other" where it is none of them, and beside it the angles that are drawn now, also on their way
/// and where a stiff neck or the size of the patient stops them; the latter is said below them.
class HeadPositionRow : public QWidget
{
    Q_OBJECT

public:
    explicit HeadPositionRow(QWidget* parent = nullptr);

    /// @pre the model outlives the row.
    void setModel(HeadPositionModel& model);

private:
    void offerPositions();
    void choose(int place);
    void refresh();

    HeadPositionModel* m_model = nullptr;
    QComboBox* m_positions; ///< each with its name as data
    QLabel* m_present;      ///< "neck 35° flexed", and below "head 24° extended"
    QLabel* m_limit;        ///< "This patient's neck flexes no farther."
};

} // namespace carina
