// Two runs side by side: which inputs differ, and their key figures.
#pragma once

#include <QDialog>

#include "ui/runs/run_list.h"

namespace rotorbench {

class CompareDialog : public QDialog {
  Q_OBJECT

 public:
  CompareDialog(const RunRecord& left, const RunRecord& right, QWidget* parent = nullptr);
};

}  // namespace rotorbench
