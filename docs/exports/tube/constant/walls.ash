patchInteractionModel ashImpact;
ashImpactCoeffs { record all; }
